// The bodies of one shape, as rectangles in one list.
//
// Instances would be the usual way, but on a processor each instance costs as much as a draw call. So the rectangles of all bodies are one
// constant list. The positions of the bodies are in a texture with four texels per body: the images of the three unit vectors, and the
// position with the brightness.

import * as THREE from "three";

/** The number of bodies in a row of the texture. */
const IN_A_ROW = 256;

/** A corner of a rectangle: its place in the rectangle, the index of the rectangle in the body, and the index of the body. */
const HEAD = `
  precision highp float;
  precision highp sampler2D;
  uniform sampler2D bodies;
  uniform mat4 viewMatrix;
  uniform mat4 projectionMatrix;
  in vec4 position;
  vec4 texel(int index) {
    int body = int(position.w);
    return texelFetch(bodies, ivec2(4 * (body % ${IN_A_ROW}) + index, body / ${IN_A_ROW}), 0);
  }
  vec3 toEye(vec3 direction) { return (viewMatrix * vec4(direction, 0.0)).xyz; }
  vec3 sun() { return normalize(toEye(vec3(0.45, 0.8, 0.4))); }`;

/** Light from above, and ambient light. */
const LIGHT = `
  uniform vec3 color;
  #ifdef IS_FLAT
  vec3 lit(float shade, float slope) { return color * shade; }
  #else
  vec3 lit(float shade, float slope) { return color * shade * (0.45 + 0.6 * max(slope, 0.0)); }
  #endif`;

/**
 * A ball or a capsule is a rectangle that faces the eye. Each point has its distance from the axis in radii, which gives the outline and the
 * normal.
 */
const ROUND = {
  vertexShader: `${HEAD}
    uniform float halfLength;
    out vec2 spot;
    out float straight;
    out vec3 light;
    out float shade;
    void main() {
      vec4 place = texel(3);
      vec3 up = texel(1).xyz;
      float radius = length(up);
      vec3 axis = halfLength * toEye(up);
      straight = length(axis.xy) / radius;
      vec2 along = straight > 1e-4 ? axis.xy / (straight * radius) : vec2(1.0, 0.0);
      vec2 across = vec2(-along.y, along.x);
      spot = position.xy * vec2(1.0 + straight, 1.0);
      vec3 corner = vec3(radius * (along * spot.x + across * spot.y), axis.z * position.x);
      gl_Position = projectionMatrix * vec4((viewMatrix * vec4(place.xyz, 1.0)).xyz + corner, 1.0);
      light = vec3(dot(sun().xy, along), dot(sun().xy, across), sun().z);
      shade = place.w;
    }`,
  fragmentShader: `
    precision highp float;
    ${LIGHT}
    in vec2 spot;
    in float straight;
    in vec3 light;
    in float shade;
    out vec4 pixel;
    void main() {
      vec2 normal = vec2(spot.x - clamp(spot.x, -straight, straight), spot.y);
      float square = dot(normal, normal);
      float alpha = 1.0;
      #ifdef IS_SMOOTH
      alpha = clamp((1.0 - square) / fwidth(square) + 0.5, 0.0, 1.0);
      #else
      if (square > 1.0) discard;
      #endif
      pixel = vec4(lit(shade, dot(vec3(normal, sqrt(max(1.0 - square, 0.0))), light)), alpha);
    }`,
};

/** The three sides of a box that face the eye. */
const ANGULAR = {
  vertexShader: `${HEAD}
    ${LIGHT}
    uniform vec3 cameraPosition;
    out vec3 shown;
    void main() {
      vec4 place = texel(3);
      int side = int(position.z);
      vec3 outward = texel(side).xyz;
      vec3 corner = place.xyz + position.x * texel((side + 1) % 3).xyz + position.y * texel((side + 2) % 3).xyz;
      #ifndef IS_FLAT
      if (dot(outward, cameraPosition - place.xyz) < 0.0) outward = -outward;
      corner += outward;
      #endif
      gl_Position = projectionMatrix * viewMatrix * vec4(corner, 1.0);
      shown = lit(place.w, dot(normalize(toEye(outward)), sun()));
    }`,
  fragmentShader: `
    precision highp float;
    uniform float opacity;
    in vec3 shown;
    out vec4 pixel;
    void main() {
      pixel = vec4(shown, opacity);
    }`,
};

/** The rectangles of `count` bodies. In 2D, a box is its third side. */
function rectangles(count, sides) {
  const corners = new Float32Array(count * sides.length * 16);
  const triangles = new Uint32Array(count * sides.length * 6);
  for (let rectangle = 0; rectangle < count * sides.length; rectangle += 1) {
    const [side, body] = [sides[rectangle % sides.length], Math.floor(rectangle / sides.length)];
    corners.set([-1, -1, side, body, 1, -1, side, body, 1, 1, side, body, -1, 1, side, body], rectangle * 16);
    triangles.set([0, 1, 2, 0, 2, 3].map((corner) => 4 * rectangle + corner), rectangle * 6);
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(corners, 4));
  geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
  return geometry;
}

/** All bodies of one shape in a world, with a given capacity. */
export class Bodies {
  constructor({ shape, length, count, isFlat, isSmooth }) {
    const isWall = shape === "wall";
    const isRound = ["ball", "rock", "capsule"].includes(shape);
    this.isFixed = isWall || shape === "rock";
    this.capacity = 2 ** Math.ceil(Math.log2(Math.max(count, IN_A_ROW)));
    const size = [4 * IN_A_ROW, this.capacity / IN_A_ROW];
    this.texture = new THREE.DataTexture(new Float32Array(16 * this.capacity), ...size, THREE.RGBAFormat, THREE.FloatType);
    const opacity = isWall ? (isFlat ? 0.5 : 0.14) : 1;
    const uniforms = { color: new THREE.Color(), bodies: this.texture, halfLength: length / 2, opacity };
    const material = new THREE.RawShaderMaterial({
      ...(isRound ? ROUND : ANGULAR),
      glslVersion: THREE.GLSL3,
      uniforms: Object.fromEntries(Object.entries(uniforms).map(([name, value]) => [name, { value }])),
      defines: { ...(isFlat && { IS_FLAT: true }), ...(isSmooth && { IS_SMOOTH: true }) },
      side: THREE.DoubleSide,
      forceSinglePass: true,
      alphaToCoverage: isRound && isSmooth,
      transparent: isWall,
      depthWrite: !isWall,
    });
    const sides = isRound || isFlat ? [2] : [0, 1, 2];
    this.indexes = 6 * sides.length;
    this.mesh = new THREE.Mesh(rectangles(this.capacity, sides), material);
    this.mesh.frustumCulled = false;
  }

  /** Sets the positions: sixteen numbers per body. */
  place(places) {
    this.texture.image.data.set(places);
    this.texture.needsUpdate = true;
    this.mesh.geometry.setDrawRange(0, this.indexes * (places.length / 16));
  }

  recolor(color) {
    this.mesh.material.uniforms.color.value.copy(color);
  }

  /** Frees the memory of the graphics card. */
  dispose() {
    this.mesh.removeFromParent();
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.texture.dispose();
  }
}
