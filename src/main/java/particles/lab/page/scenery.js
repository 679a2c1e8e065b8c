// What does not move: planes, balls and wires.
import * as THREE from 'three';

const WIRE = 0x6c7683;

const LINES = 7;                        // about so many lines of the ground in the height of the picture
const HAZE = 5;                         // in so many heights of the picture the ground fades into the haze

/** @returns the balls and wires to draw */
export const scenery = facts => [...facts.spheres.map(ball), ...facts.wires.map(wire)];

/** A plane with a grid and shadows, which fades into the haze. */
export class Ground {
  /** It is drawn lower by a radius: the centre of a ball that rests is on the plane, so its picture touches it. */
  constructor({point, normal}, radius) {
    this.normal = new THREE.Vector3(...normal).normalize();
    this.point = new THREE.Vector3(...point).addScaledVector(this.normal, -radius);
    const along = this.normal.clone().cross(Math.abs(this.normal.x) < 0.7 ? new THREE.Vector3(1, 0, 0)
        : new THREE.Vector3(0, 0, 1)).normalize();
    const material = new THREE.MeshLambertMaterial({color: 0x9aa6b2, side: THREE.DoubleSide, transparent: true});
    this.grid = {value: new THREE.Vector4()};
    this.mesh = new THREE.Mesh(new THREE.PlaneGeometry(), material);
    this.mesh.quaternion.setFromRotationMatrix(new THREE.Matrix4().makeBasis(along.clone().cross(this.normal), along,
        this.normal));
    this.mesh.receiveShadow = true;
    this.mesh.renderOrder = -1;         // before all else that is transparent
    material.onBeforeCompile = shader => {
      shader.uniforms.grid = this.grid;
      shader.vertexShader = 'uniform vec4 grid;\nvarying vec2 place;\n' + shader.vertexShader.replace(
          '#include <begin_vertex>', '#include <begin_vertex>\nplace = 6.0 * grid.w * position.xy;');
      shader.fragmentShader = 'uniform vec4 grid;\nvarying vec2 place;\n' + shader.fragmentShader.replace(
          '#include <color_fragment>', `
          vec2 at = (place + grid.xy) / grid.z, pixel = fwidth(at);
          vec2 line = clamp(1.0 - abs(fract(at + 0.5) - 0.5) / pixel, 0.0, 1.0) * min(vec2(1.0), 0.25 / pixel);
          diffuseColor.rgb *= 1.0 - 0.35 * max(line.x, line.y);
          diffuseColor.a = exp(-dot(place, place) / (grid.w * grid.w));`);
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

function ball({centre, radius, hollow}) {
  const mesh = new THREE.Mesh(new THREE.SphereGeometry(radius, 48, 32), new THREE.MeshLambertMaterial({
    color: 0x8fa3b8, side: hollow ? THREE.BackSide : THREE.FrontSide, transparent: hollow,
    opacity: hollow ? 0.5 : 1}));
  mesh.position.set(...centre);
  mesh.castShadow = !hollow;
  return mesh;
}

function wire(points) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(points, 3));
  return new THREE.Line(geometry, new THREE.LineBasicMaterial({color: WIRE}));
}
