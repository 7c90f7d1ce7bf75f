// One view: the bodies of a world as instances of few shapes with few triangles, drawn by three.js.

import * as THREE from "three";
import { OrbitControls } from "./three/OrbitControls.js";

/** With more bodies than this, each is so small that a ball of 20 triangles looks like one. */
const MANY = 1500;
/** And with more than this, one of 8. */
const VERY_MANY = 6000;

/** Whether a processor draws in place of a graphics card. Smooth edges would double its work. */
function isDrawnBySoftware() {
  const context = document.createElement("canvas").getContext("webgl");
  const info = context?.getExtension("WEBGL_debug_renderer_info");
  return /SwiftShader|llvmpipe|Basic Render/.test(info ? context.getParameter(info.UNMASKED_RENDERER_WEBGL) : "");
}

/** A shape of radius or half width 1. */
function geometry(shape, length, isFlat, count) {
  switch (shape) {
    case "ball":
    case "rock":
      return isFlat ? new THREE.CircleGeometry(1, count > MANY ? 10 : 20) : roundSolid(count);
    case "capsule":
      return isFlat ? flatCapsule(length) : new THREE.CapsuleGeometry(1, length, 2, 6);
    default:
      return isFlat ? new THREE.PlaneGeometry(2, 2) : new THREE.BoxGeometry(2, 2, 2);
  }
}

function roundSolid(count) {
  return count > VERY_MANY ? new THREE.OctahedronGeometry(1) : new THREE.IcosahedronGeometry(1, count > MANY ? 0 : 1);
}

function flatCapsule(length) {
  const outline = new THREE.Shape();
  outline.absarc(0, length / 2, 1, 0, Math.PI);
  outline.absarc(0, -length / 2, 1, Math.PI, 2 * Math.PI);
  return new THREE.ShapeGeometry(outline, 5);
}

/** A camera for all views, so that they show the same part of their worlds. */
export class Camera {
  constructor(bounds, isFlat) {
    const [low, high] = [bounds.slice(0, 3), bounds.slice(3)].map((corner) => new THREE.Vector3(...corner));
    this.isFlat = isFlat;
    this.target = low.clone().add(high).multiplyScalar(0.5);
    this.size = high.sub(low);
    this.radius = this.size.length() / 2;
    this.lens = isFlat
      ? new THREE.OrthographicCamera()
      : new THREE.PerspectiveCamera(35, 1, this.radius / 100, this.radius * 50);
    this.lens.position.copy(this.target).add(new THREE.Vector3(0, 0, 10));
    this.direction = new THREE.Vector3(0.55, 0.42, 1).normalize();
    this.fit(1);
  }

  /** Has everything in sight where pictures have this width per height. */
  fit(aspect) {
    if (aspect === this.aspect) return;
    const isFirst = this.aspect === undefined;
    this.aspect = aspect;
    if (this.isFlat) {
      const half = 0.53 * Math.max(this.size.y, this.size.x / aspect);
      Object.assign(this.lens, { left: -half * aspect, right: half * aspect, top: half, bottom: -half });
    } else {
      const old = isFirst ? this.direction : this.lens.position.clone().sub(this.target).normalize();
      const half = Math.tan(THREE.MathUtils.degToRad(35 / 2)) * Math.min(1, aspect);
      this.lens.position.copy(this.target).addScaledVector(old, (0.82 * this.radius) / half);
      this.lens.aspect = aspect;
    }
    this.lens.updateProjectionMatrix();
  }
}

/** What one broad phase's world looks like. */
export class View {
  constructor(canvas, name) {
    this.canvas = canvas;
    this.name = name;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: !isDrawnBySoftware() });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
  }

  /** Begins with a new world. */
  begin(camera) {
    this.controls?.dispose();
    this.camera = camera;
    this.controls = new OrbitControls(camera.lens, this.canvas);
    this.controls.target = camera.target;
    this.controls.enableRotate = !camera.isFlat;
    if (camera.isFlat) {
      this.controls.mouseButtons.LEFT = THREE.MOUSE.PAN;
      this.controls.touches.ONE = THREE.TOUCH.PAN;
    }
    for (const mesh of this.meshes ?? []) mesh?.dispose();
    this.meshes = [];
    this.lines = {};
    this.scene = new THREE.Scene();
    const sun = new THREE.DirectionalLight(0xffffff, 2);
    sun.position.set(0.5, 1, 0.8);
    this.scene.add(sun, new THREE.HemisphereLight(0xffffff, 0x8090a0, 1.6));
    this.recolor();
  }

  /** Takes the colours of the page. */
  recolor() {
    const style = getComputedStyle(this.canvas);
    this.color = (name) => new THREE.Color(style.getPropertyValue(`--${name}`).trim());
    this.scene.background = this.color("panel");
    for (const mesh of this.meshes) mesh?.material.color.copy(this.color(mesh.userData.color));
    for (const line of Object.values(this.lines)) line.material.color.copy(this.color(line.userData.color));
  }

  /** Takes over where everything is. */
  update(side, { boxes, pairs }) {
    const count = side.draw();
    for (let batch = 0; batch < count; batch += 1) {
      const matrices = side.batch_matrices(batch);
      const mesh = this.mesh(side, batch, matrices.length / 16);
      mesh.instanceMatrix.array.set(matrices);
      mesh.instanceColor.array.set(side.batch_shades(batch));
      mesh.instanceMatrix.needsUpdate = true;
      mesh.instanceColor.needsUpdate = true;
    }
    this.draw("boxes", "text", boxes ? side.box_lines() : []);
    this.draw("idle", "idle", pairs ? side.pair_lines(false) : []);
    this.draw("touch", "touch", pairs ? side.pair_lines(true) : []);
  }

  render() {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    const size = this.renderer.getSize(new THREE.Vector2());
    if (size.x !== clientWidth || size.y !== clientHeight) this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.fit(clientWidth / clientHeight);
    this.controls.update();
    this.renderer.render(this.scene, this.camera.lens);
  }

  /** The instances of a batch, with room for so many. */
  mesh(side, batch, count) {
    let mesh = this.meshes[batch];
    if (mesh === undefined || mesh.userData.capacity < count) {
      if (mesh !== undefined) {
        this.scene.remove(mesh);
        mesh.geometry.dispose();
        mesh.dispose();
      }
      mesh = this.newMesh(side.batch_shape(batch), side.batch_length(batch), count);
      this.meshes[batch] = mesh;
      this.scene.add(mesh);
    }
    mesh.count = count;
    return mesh;
  }

  newMesh(shape, length, count) {
    const isFlat = this.camera.isFlat;
    const isWall = shape === "wall";
    const color = isWall || shape === "rock" ? "wall" : `${this.name}-body`;
    const Material = isFlat ? THREE.MeshBasicMaterial : THREE.MeshLambertMaterial;
    const material = new Material({ color: this.color(color) });
    if (isWall) Object.assign(material, { transparent: true, opacity: isFlat ? 0.5 : 0.14, depthWrite: false });
    const capacity = 2 ** Math.ceil(Math.log2(Math.max(count, 16)));
    const mesh = new THREE.InstancedMesh(geometry(shape, length, isFlat, count), material, capacity);
    mesh.instanceColor = new THREE.InstancedBufferAttribute(new Float32Array(3 * capacity), 3);
    mesh.frustumCulled = false;
    mesh.userData = { capacity, color };
    return mesh;
  }

  /** Draws lines over everything, from the ends in a list of coordinates. */
  draw(name, color, ends) {
    let line = this.lines[name];
    if (line === undefined) {
      if (ends.length === 0) return;
      const material = new THREE.LineBasicMaterial({ color: this.color(color), transparent: true });
      material.depthTest = name === "boxes" && !this.camera.isFlat;
      if (name === "boxes") material.opacity = 0.45;
      line = new THREE.LineSegments(new THREE.BufferGeometry(), material);
      line.frustumCulled = false;
      line.userData = { color };
      this.lines[name] = line;
      this.scene.add(line);
    }
    line.visible = ends.length > 0;
    let attribute = line.geometry.getAttribute("position");
    if (attribute === undefined || attribute.array.length < ends.length) {
      line.geometry.dispose();
      attribute = new THREE.BufferAttribute(new Float32Array(3 * Math.ceil(ends.length / 2)), 3);
      line.geometry.setAttribute("position", attribute);
    }
    attribute.array.set(ends);
    attribute.needsUpdate = true;
    line.geometry.setDrawRange(0, ends.length / 3);
  }
}
