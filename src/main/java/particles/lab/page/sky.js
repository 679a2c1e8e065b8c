// Light and sky, as in the frames: one distant lamp, and a sky whose light is stronger from above.
import * as THREE from 'three';

const DAY = {top: 0xa9c3dc, horizon: 0xf1f2f0, bottom: 0xdde2e6, ground: 0xe8e4dc, line: 0xc9c3b8};
const NIGHT = {top: 0x080b14, horizon: 0x1d2433, bottom: 0x0e1119, ground: 0x23252b, line: 0x34373f};
const AMBIENT = 0.54, FROM_ABOVE = 0.09, LAMP = 0.5, HIGHLIGHT = 0.28;

/** The light on a plane whose normal is not up, relative to one whose normal is up. */
export function light(normal, lamp, up) {
  const on = some => FROM_ABOVE * up.dot(some) + LAMP * Math.max(0, lamp.dot(some));
  return Math.max(0.5, 1 + 0.35 * (on(normal) - on(up)));
}

/** A material in the light of the scene's lamp and hemisphere; gloss: its highlight's; contrast: light against dark. */
export function solid(options, gloss = 1, contrast = 1) {
  const material = new THREE.MeshLambertMaterial(options);
  material.onBeforeCompile = shader => {
    Object.assign(shader.uniforms, {gloss: {value: HIGHLIGHT * gloss}, contrast: {value: contrast}});
    shader.fragmentShader = 'uniform float gloss, contrast;\n' + shader.fragmentShader.replace(
        '#include <colorspace_fragment>', `
        vec3 lamp = directionalLights[0].direction, up = hemisphereLights[0].direction;
        float bright = ${AMBIENT} + ${FROM_ABOVE} * dot(up, normal) + ${LAMP} * max(0.0, dot(lamp, normal));
        float shine = pow(max(0.0, dot(normalize(lamp + vec3(0.0, 0.0, 1.0)), normal)), 32.0);
        gl_FragColor = vec4(mix(1.0, bright, contrast) * linearToOutputTexel(diffuseColor).rgb + gloss * shine,
            diffuseColor.a);`);
  };
  return material;
}

/** What is behind the scene: with a ground, a sky down to the horizon; without one, a screen. */
export class Sky {
  constructor(up, hasGround) {
    this.colours = Object.fromEntries(Object.keys(DAY).map(name => [name, {value: new THREE.Color()}]));
    this.mesh = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), new THREE.ShaderMaterial({
      uniforms: {...this.colours, up: {value: up}, hasGround: {value: hasGround}}, depthTest: false, depthWrite: false,
      vertexShader: `
        varying vec3 ray;
        varying float below;
        void main() {
          gl_Position = vec4(position.xy, 0.0, 1.0);
          below = 0.5 - 0.5 * position.y;
          ray = transpose(mat3(viewMatrix))
              * vec3(position.x / projectionMatrix[0][0], position.y / projectionMatrix[1][1], -1.0);
        }`,
      fragmentShader: `
        uniform vec3 top, horizon, bottom, up;
        uniform bool hasGround;
        varying vec3 ray;
        varying float below;
        void main() {
          gl_FragColor = vec4(hasGround ? mix(horizon, top, clamp(dot(normalize(ray), up) / 0.45, 0.0, 1.0))
              : below < 0.62 ? mix(top, horizon, below / 0.62) : mix(horizon, bottom, (below - 0.62) / 0.38), 1.0);
        }`}));
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -2;         // before all else
  }

  /** background: a colour in place of the sky, or -1 */
  setColours(night, background) {
    const sky = background < 0 ? {} : {top: background, horizon: background, bottom: background};
    for (const [name, colour] of Object.entries({...night ? NIGHT : DAY, ...sky})) {
      this.colours[name].value.setHex(colour, THREE.LinearSRGBColorSpace);      // the screen's, as shaders write them
    }
  }
}
