// Where a scene is looked at from. People turn, zoom and pan it with the mouse, fingers or keys.
import * as THREE from 'three';
import {OrbitControls} from 'orbit';

const AHEAD = 0.5;                      // so many seconds of a particle's way at its velocity are in the picture too
const WIDE = 1.5;                       // width over height; a scene's camera is meant for pictures as wide as that
const MOST_GROWTH = 20;                 // after that, particles leave the picture, unless the run fails: it is seen how

export class SceneCamera {
  /** canvas: what people turn the picture on; changed() is called when they do */
  constructor(element, canvas, changed) {
    Object.assign(this, {element, canvas, changed});
    this.camera = new THREE.PerspectiveCamera(35, 1, 0.01, 1000);
    element.addEventListener('keydown', event => this.turnByKey(event));
  }

  /** Goes where the scene says or, if it does not, to where all of the scene is in the picture. */
  open(facts, structure, state) {
    this.facts = facts;
    this.turned = false;
    this.box = boxOf(facts, structure, state);
    this.extent = Math.max(1e-6, this.box.getBoundingSphere(new THREE.Sphere()).radius);
    this.fails = false;
    this.place();
  }

  /** Sets the target and, there, the height of the picture (m). */
  place() {
    const {camera, box} = this, sphere = box.getBoundingSphere(new THREE.Sphere()), given = this.facts.camera;
    const extent = Math.max(1e-6, sphere.radius);
    camera.fov = given?.perspective ? given.fieldOfView : 35;
    const half = Math.tan(camera.fov * Math.PI / 360);
    this.target = given && !this.fails ? new THREE.Vector3(...given.target) : sphere.center.clone();
    const flat = box.max.z - box.min.z < 0.05 * extent;
    const from = given ? new THREE.Vector3(...given.position).sub(new THREE.Vector3(...given.target))
        : (flat ? new THREE.Vector3(0.22, 0.16, 1) : new THREE.Vector3(0.55, 0.42, 1));
    const distance = !given || this.fails ? 1.15 * extent / Math.sin(Math.atan(half * Math.min(1, camera.aspect)))
        : Math.max(1, WIDE / camera.aspect) * (given.perspective ? from.length() : given.height / 2 / half);
    camera.up.set(...(given?.up ?? [0, 1, 0]));
    camera.near = distance / 1000;
    camera.far = distance * 100;
    camera.position.copy(this.target).addScaledVector(from.normalize(), distance);
    camera.updateProjectionMatrix();
    this.viewHeight = 2 * distance * half;
    this.controls?.dispose();
    this.controls = new OrbitControls(camera, this.canvas);
    this.controls.target.copy(this.target);
    this.controls.addEventListener('start', () => { this.turned = true; });
    this.controls.addEventListener('change', this.changed);
    this.controls.update();
    camera.updateMatrixWorld();
  }

  /** The height of the picture at the target (m), as it is now; viewHeight is that of the first view. */
  seenHeight() {
    const {position, fov} = this.camera;
    return 2 * position.distanceTo(this.controls.target) * Math.tan(fov * Math.PI / 360);
  }

  /** Where somebody has turned it to: its position, its target and how wide the picture is; else undefined. */
  describe() {
    return this.turned ? this.pose() : undefined;
  }

  pose() {
    return this.controls ? [...this.camera.position.toArray(), ...this.controls.target.toArray(), this.camera.aspect]
        : [];
  }

  /** Goes where somebody had turned it to. */
  restore(numbers) {
    if (numbers?.length === 7 && numbers.every(Number.isFinite)) {
      this.turned = true;
      this.camera.position.fromArray(numbers);
      this.controls.target.fromArray(numbers, 3);
      this.fitInto(numbers[6]);
    }
  }

  /** Goes farther away where the picture is narrower than it was, as on a phone. */
  fitInto(aspectBefore) {
    const away = aspect => Math.max(1, WIDE / aspect), {position, aspect} = this.camera;
    position.sub(this.controls.target).multiplyScalar(away(aspect) / away(aspectBefore)).add(this.controls.target);
    this.controls.update();
  }

  /**
   * Goes farther away when particles leave the picture, unless somebody has placed the camera or, of a run that does
   * not fail, the scene has.
   */
  follow(state, fails) {
    this.fails ||= Boolean(fails);
    if (this.facts.camera && !this.fails || this.turned) {
      return;
    }
    const grown = this.box.clone();
    for (let i = 0; 6 * i < state.length; i++) {
      const p = pointAhead(state, i, 0).project(this.camera);
      if (!(Math.abs(p.x) < 0.95 && Math.abs(p.y) < 0.95 && p.z < 1)) {
        grown.expandByPoint(pointAhead(state, i, 0)).expandByPoint(pointAhead(state, i, this.fails ? 0 : AHEAD));
      }
    }
    if (!grown.equals(this.box) && grown.getBoundingSphere(new THREE.Sphere()).radius
        < (this.fails ? Infinity : MOST_GROWTH * this.extent)) {
      this.box = grown;
      this.place();
    }
  }

  /** Where a point is seen: pixels, or null behind the camera. */
  placeOf(point) {
    const p = new THREE.Vector3(...point).project(this.camera);
    return p.z > 1 ? null : [(p.x + 1) / 2 * this.element.clientWidth, (1 - p.y) / 2 * this.element.clientHeight];
  }

  turnByKey(event) {
    const turns = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]};
    const nearer = {'+': 0.9, '=': 0.9, '-': 1 / 0.9}[event.key];
    if (!this.controls || !turns[event.key] && !nearer) {
      return;
    }
    event.preventDefault();
    this.turned = true;
    const offset = new THREE.Spherical().setFromVector3(this.camera.position.clone().sub(this.controls.target));
    const [theta, phi] = turns[event.key] ?? [0, 0];
    offset.theta += theta;
    offset.phi = Math.max(0.01, Math.min(Math.PI - 0.01, offset.phi + phi));
    offset.radius *= nearer ?? 1;
    this.camera.position.setFromSpherical(offset).add(this.controls.target);
    this.controls.update();
  }

  resize() {
    const before = this.camera.aspect;
    this.camera.aspect = this.element.clientWidth / this.element.clientHeight;
    this.camera.updateProjectionMatrix();
    if (this.turned) {
      this.fitInto(before);
    } else if (this.box) {
      this.place();
    }
  }
}

/** Where a particle is, or will be at its present velocity. */
export const pointAhead = (state, i, seconds) => new THREE.Vector3().fromArray(state, 6 * i)
    .addScaledVector(new THREE.Vector3().fromArray(state, 6 * i + 3), seconds);

/** All particles, the planes below them and balls; with gravity, also where particles can swing from fixed ones. */
function boxOf(facts, structure, state) {
  const box = new THREE.Box3(), pegs = new THREE.Box3();
  for (let i = 0; i < structure.ids.length; i++) {
    const point = pointAhead(state, i, 0);
    box.expandByPoint(point).expandByPoint(pointAhead(state, i, AHEAD));
    if (structure.fixed[i]) {
      pegs.expandByPoint(point);
    }
    for (const plane of facts.planes) {
      const normal = new THREE.Vector3(...plane.normal), on = new THREE.Vector3(...plane.point);
      box.expandByPoint(point.clone().addScaledVector(normal, normal.dot(on.sub(point))));
    }
  }
  for (const ball of facts.spheres) {
    box.expandByPoint(new THREE.Vector3(...ball.centre).addScalar(ball.radius));
    box.expandByPoint(new THREE.Vector3(...ball.centre).addScalar(-ball.radius));
  }
  if (!pegs.isEmpty() && facts.energies.includes('gravity')) {
    const middle = pegs.getCenter(new THREE.Vector3());
    let reach = 0;
    for (let i = 0; i < structure.ids.length; i++) {
      reach = Math.max(reach, middle.distanceTo(pointAhead(state, i, 0)));
    }
    box.expandByPoint(middle.clone().add(new THREE.Vector3(reach, 0, 0)));
    box.expandByPoint(middle.clone().sub(new THREE.Vector3(reach, reach, 0)));
  }
  if (box.isEmpty()) {
    box.setFromCenterAndSize(new THREE.Vector3(), new THREE.Vector3(2, 2, 2));
  }
  return box;
}
