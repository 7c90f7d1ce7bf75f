// One view of a world, drawn by three.js.

import * as THREE from "three";
import { Bodies } from "./bodies.js";
import { OrbitControls } from "./three/OrbitControls.js";

// Colours are those of the style sheet, without colour management.
THREE.ColorManagement.enabled = false;

/** Whether a processor draws instead of a graphics card. There, antialiasing would double the time. */
function isDrawnBySoftware() {
  const context = document.createElement("canvas").getContext("webgl");
  const info = context?.getExtension("WEBGL_debug_renderer_info");
  return /SwiftShader|llvmpipe|Basic Render/.test(info ? context.getParameter(info.UNMASKED_RENDERER_WEBGL) : "");
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

  /** Shows the whole scene in pictures with this aspect ratio. */
  fit(aspect) {
    if (aspect === this.aspect) return;
    const isFirst = this.aspect === undefined;
    this.aspect = aspect;
    if (this.isFlat) {
      const half = 0.53 * Math.max(this.size.y, this.size.x / aspect);
      Object.assign(this.lens, { left: -half * aspect, right: half * aspect, top: half, bottom: -half });
    } else {
      const old = isFirst ? this.direction : this.lens.position.clone().sub(this.target).normalize();
      this.lens.position.copy(this.target).addScaledVector(old, 1.03 * this.distance(old, aspect));
      this.lens.aspect = aspect;
    }
    this.lens.updateProjectionMatrix();
  }

  /** The distance in this direction from which the eight corners of the scene are just visible. */
  distance(direction, aspect) {
    const half = Math.tan(THREE.MathUtils.degToRad(35 / 2));
    const right = new THREE.Vector3(0, 1, 0).cross(direction).normalize();
    const up = direction.clone().cross(right);
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((corner) =>
      this.size.clone().multiply(new THREE.Vector3(corner & 1, (corner >> 1) & 1, corner >> 2).subScalar(0.5)),
    );
    return Math.max(
      ...corners.map((corner) => {
        const width = Math.max(Math.abs(corner.dot(right)) / aspect, Math.abs(corner.dot(up)));
        return corner.dot(direction) + width / half;
      }),
    );
  }
}

/** The view of the world on one broad phase. */
export class View {
  constructor(canvas, name) {
    this.canvas = canvas;
    this.name = name;
    this.isSmooth = !isDrawnBySoftware();
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: this.isSmooth });
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
  }

  /** Reduces the resolution, down to a quarter of that of the page. */
  coarsen() {
    this.renderer.setPixelRatio(Math.max(this.renderer.getPixelRatio() * 0.7, 0.5));
  }

  /** Starts with a new world. */
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
    for (const bodies of this.batches ?? []) bodies.dispose();
    this.batches = [];
    this.lines = {};
    this.scene = new THREE.Scene();
    this.recolor();
  }

  /** Reads the colours of the page. */
  recolor() {
    const style = getComputedStyle(this.canvas);
    this.color = (name) => new THREE.Color(style.getPropertyValue(`--${name}`).trim());
    this.scene.background = this.color("panel");
    for (const bodies of this.batches) bodies.recolor(this.colorOf(bodies));
    for (const line of Object.values(this.lines)) line.material.color.copy(this.color(line.userData.color));
  }

  /** Reads the positions of the world. */
  update(side, { boxes, pairs, search }) {
    const batches = side.draw();
    for (let batch = 0; batch < batches; batch += 1) {
      const places = side.batch_places(batch);
      const count = places.length / 16;
      if (!(this.batches[batch]?.capacity >= count)) this.batches[batch] = this.newBodies(side, batch, count);
      this.batches[batch].place(places);
    }
    this.draw("boxes", "text", boxes ? side.box_lines() : []);
    this.draw("fat", "fat", search ? side.fat_box_lines() : []);
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

  /** Waits until the picture is complete. */
  finish() {
    const context = this.renderer.getContext();
    context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, new Uint8Array(4));
  }

  /** Replaces the bodies of a batch by bodies with a larger capacity. */
  newBodies(side, batch, count) {
    this.batches[batch]?.dispose();
    const [shape, length] = [side.batch_shape(batch), side.batch_length(batch)];
    const bodies = new Bodies({ shape, length, count, isFlat: this.camera.isFlat, isSmooth: this.isSmooth });
    bodies.recolor(this.colorOf(bodies));
    this.scene.add(bodies.mesh);
    return bodies;
  }

  colorOf(bodies) {
    return this.color(bodies.isFixed ? "wall" : `${this.name}-body`);
  }

  /** Draws lines on top, from a list with the coordinates of their ends. */
  draw(name, color, ends) {
    let line = this.lines[name];
    if (line === undefined) {
      if (ends.length === 0) return;
      const material = new THREE.LineBasicMaterial({ color: this.color(color), transparent: true });
      const isBoxes = name === "boxes" || name === "fat";
      material.depthTest = isBoxes && !this.camera.isFlat;
      if (isBoxes) material.opacity = 0.45;
      line = new THREE.LineSegments(new THREE.BufferGeometry(), material);
      line.frustumCulled = false;
      line.userData = { color };
      // In both views, the pairs without contact are on top.
      line.renderOrder = ["fat", "boxes", "touch", "idle"].indexOf(name) + 1;
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
