// What does not move: planes, balls and wires.
import * as THREE from 'three';
import {light, solid} from './sky.js';
import {wire} from './tubes.js';

const LINES = 7;                        // about so many lines of the ground in the height of the picture
const DARKEST_SHADOW = 0.56;            // of the light beside it
const SPACING = Math.PI / 12;           // of the grid on the wall of a hollow
const HAZE = 5;                         // in so many heights of the picture the ground fades into the haze

/** How much of a pixel a line of a grid takes whose lines are at whole numbers; pixel: its size there. */
const COVERAGE = `
    vec2 coverage(vec2 at, vec2 pixel) {
      return clamp(1.0 - abs(fract(at + 0.5) - 0.5) / pixel, 0.0, 1.0) * min(vec2(1.0), 0.25 / pixel);
    }
    `;

/** @returns the spheres and wires to draw; ball: the radius of balls; reach: how far one that rests reaches (m) */
export const scenery = (facts, ball, reach) => [...facts.spheres.map(one => sphere(one, reach)),
  ...facts.wires.map(points => wire(points, ball))];

/** A plane with a grid and shadows, which fades into the haze. */
export class Ground {
  /** It is drawn lower by a radius: the centre of a ball that rests is on the plane, so its picture touches it. */
  constructor({point, normal}, radius, sky, lamp, up) {
    this.normal = new THREE.Vector3(...normal).normalize();
    this.point = new THREE.Vector3(...point).addScaledVector(this.normal, -radius);
    const along = this.normal.clone().cross(Math.abs(this.normal.x) < 0.7 ? new THREE.Vector3(1, 0, 0)
        : new THREE.Vector3(0, 0, 1)).normalize();
    const material = new THREE.ShadowMaterial({side: THREE.DoubleSide});
    this.grid = {value: new THREE.Vector4()};
    this.mesh = new THREE.Mesh(new THREE.PlaneGeometry(), material);
    this.mesh.quaternion.setFromRotationMatrix(new THREE.Matrix4().makeBasis(along.clone().cross(this.normal), along,
        this.normal));
    this.mesh.receiveShadow = true;
    this.mesh.renderOrder = -1;         // before all else that is transparent
    material.onBeforeCompile = shader => {
      Object.assign(shader.uniforms, {ground: sky.colours.ground, line: sky.colours.line, grid: this.grid,
        light: {value: light(this.normal, lamp, up)},
        darkest: {value: lamp.dot(this.normal) > 0.05 ? DARKEST_SHADOW : 1}});
      shader.vertexShader = 'uniform vec4 grid;\nvarying vec2 place;\n' + shader.vertexShader.replace(
          '#include <begin_vertex>', '#include <begin_vertex>\nplace = 6.0 * grid.w * position.xy;');
      shader.fragmentShader = COVERAGE + `
          uniform vec3 ground, line;
          uniform vec4 grid;
          uniform float light, darkest;
          varying vec2 place;
          ` + shader.fragmentShader.replace('#include <colorspace_fragment>', `
          vec2 at = (place + grid.xy) / grid.z, near = coverage(at, fwidth(at));
          float shadow = gl_FragColor.a;
          gl_FragColor = vec4(mix(ground, line, max(near.x, near.y)) * light * mix(1.0, darkest, shadow),
              exp(-dot(place, place) / (grid.w * grid.w)));`);
    };
  }

  /** Around the target, for a picture of this height (m). */
  place(target, viewHeight) {
    const {mesh, normal, point} = this, haze = HAZE * viewHeight;
    mesh.position.copy(target).addScaledVector(normal, -normal.dot(target.clone().sub(point)));
    mesh.scale.setScalar(6 * haze);
    const {x, y} = mesh.position.clone().sub(point).applyQuaternion(mesh.quaternion.clone().invert());
    this.grid.value.set(x, y, spacing(viewHeight / LINES), haze);
  }
}

/** The next of 1, 2 and 5 times a power of ten. */
function spacing(least) {
  const decade = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map(digit => digit * decade).find(value => value >= least * (1 - 1e-9));
}

/** A ball is drawn smaller, and of a hollow its far wall larger, so that balls that rest touch it. */
function sphere({centre, radius, hollow}, reach) {
  const drawn = hollow ? radius + reach : Math.max(0.3 * radius, radius - reach);
  const mesh = new THREE.Mesh(new THREE.SphereGeometry(drawn, 48, 32),
      hollow ? wall() : solid({color: 0xaebccb}));
  mesh.position.set(...centre);
  mesh.castShadow = !hollow;
  return mesh;
}

/** The inside of a hollow, with circles around its upright axis and meridians. */
function wall() {
  const material = solid({color: 0xdfe4e8, side: THREE.BackSide}, 0, 0.35), lit = material.onBeforeCompile;
  material.onBeforeCompile = shader => {
    lit(shader);
    shader.uniforms.line = {value: new THREE.Color(0xb9c1c9)};
    shader.vertexShader = 'varying vec3 place;\n' + shader.vertexShader.replace(
        '#include <begin_vertex>', '#include <begin_vertex>\nplace = position;');
    shader.fragmentShader = COVERAGE + `
        uniform vec3 line;
        varying vec3 place;
        ` + shader.fragmentShader.replace('#include <map_fragment>', `
        vec3 way = normalize(place);
        float ring = length(way.xz), pixel = max(length(dFdx(way)), length(dFdy(way))) / ${SPACING};
        vec2 near = coverage(vec2(asin(clamp(way.y, -1.0, 1.0)), ring > 0.0 ? atan(way.x, way.z) : 0.0) / ${SPACING},
            vec2(pixel, pixel / max(ring, 0.001)));
        diffuseColor.rgb = mix(diffuseColor.rgb, line, ring > 0.05 ? max(near.x, near.y) : near.x);`);
  };
  return material;
}
