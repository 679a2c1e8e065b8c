// The scene in three dimensions, drawn as in the frames; the camera, lines, marks and scenery have their own modules.
import * as THREE from 'three';
import {Blobs} from './blobs.js';
import {SceneCamera, pointAhead} from './camera.js';
import {glow} from './glow.js';
import {Marks} from './marks.js';
import {Ground, scenery} from './scenery.js';
import {Sky, solid} from './sky.js';
import {Surface, cornersOfClosed} from './surface.js';
import {Trails} from './trails.js';
import {Copies, Springs} from './tubes.js';

const LABEL_GAP = 6;                    // pixels
const FEW_BALLS = 100, CHOSEN = '#009e73';
const SHADOWS = 4.5, SHADOW_PIXELS = 1024;      // the width of the part with shadows, in heights of the picture
const ZOOM = 1.5;                       // a change of that height from which they are placed anew

// asked once: browsers drop the oldest of some 16 pictures when there are more
const CAN_DRAW = Boolean(document.createElement('canvas').getContext('webgl2'));

/** The picture; where the browser cannot draw one, a line that says so. */
export const makeView = element => CAN_DRAW ? new View(element) : new NoPicture(element);

class NoPicture {
  constructor(element) {
    element.append(TEXTS.noWebGL);
  }

  open(facts) {
    this.facts = facts;
  }

  nearest() {
    return -1;
  }

  close() {}
  choose() {}
  setStructure() {}
  setLabels() {}
  setArrows() {}
  show() {}
  draw() {}
  resize() {}
}

class View {
  constructor(element) {
    this.element = element;
    this.renderer = new THREE.WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.autoUpdate = false;         // only when something has moved
    this.renderer.shadowMap.type = THREE.PCFSoftShadowMap;
    element.append(this.renderer.domElement);
    this.camera = new SceneCamera(element, this.renderer.domElement, () => { this.stale = true; });
    this.marks = new Marks(element);
    this.matrix = new THREE.Matrix4();
    this.colour = new THREE.Color();
    this.renderer.domElement.hidden = true;      // until there is a scene
    this.resize();
  }

  // ---- a new scene ----

  open(facts, structure, state) {
    this.facts = facts;
    this.renderer.domElement.hidden = false;
    this.scene?.traverse(thing => { thing.geometry?.dispose(); thing.material?.dispose(); });
    this.scene = new THREE.Scene();
    this.fastest = 0;
    this.camera.open(facts, structure, state);
    this.ball = this.radiusOfBalls(structure);
    this.inSurface = new Set(facts.surfaces.flatMap(surface => surface.triangles));
    this.hidden = cornersOfClosed(facts.surfaces);
    this.pairs = null;
    const reach = this.reach(structure), up = this.camera.camera.up.clone().normalize(), lampward = this.findLamp(up);
    this.sky = new Sky(up, facts.planes.length > 0 && facts.camera?.perspective !== false);
    this.grounds = facts.planes.map(plane => new Ground(plane, reach, this.sky, lampward, up));
    this.lamp?.dispose();
    this.lamp = new THREE.DirectionalLight();
    this.lamp.castShadow = facts.planes.length > 0;
    this.lamp.shadow.mapSize.set(SHADOW_PIXELS, SHADOW_PIXELS);
    this.scene.add(this.lamp, this.lamp.target);
    this.towardsLamp = lampward;
    this.shine();
    const hemisphere = new THREE.HemisphereLight();
    hemisphere.position.copy(up);
    this.springs = new Springs(structure, facts.look.springColour);
    this.trails = new Trails();
    this.blobs = new Blobs(facts.look.colours[0]);
    this.blobs.object.visible = facts.look.kind === 'blobs';
    this.trails.object.visible = [facts.look, ...Object.values(facts.look.marks)].some(({trail}) => trail > 0);
    this.surfaces = facts.surfaces.map(surface => new Surface(surface, facts.look.colours.slice(2)));
    this.balls = new Copies(new THREE.SphereGeometry(1, 16, 12), solid({}));
    this.areMany = false;
    this.spots = new Copies(new THREE.PlaneGeometry(2, 2), glow(), false);
    this.scene.add(hemisphere, this.sky.mesh, this.springs.object, this.trails.object, this.blobs.object,
        this.balls.object, this.spots.object, ...this.grounds.map(ground => ground.mesh),
        ...this.surfaces.map(surface => surface.object), ...scenery(facts, this.ball, reach));
    this.resize();
  }

  radiusOfBalls({ids, restLengths}) {
    const mean = restLengths.reduce((sum, length) => sum + length / restLengths.length, 0);
    return this.facts.look.radius || Math.min(mean > 0 ? 0.26 * mean : Infinity,
        this.camera.viewHeight * Math.min(0.028, 0.3 / Math.cbrt(Math.max(1, ids.length))));
  }

  /** How far a particle that lies on a plane reaches below its centre (m). */
  reach({ids}) {
    const {kind, particles} = this.facts.look;
    const shown = particles === 'always' || particles === 'beside_surfaces' && ids.length > this.inSurface.size;
    return shown && ['balls', 'blobs'].includes(kind) ? this.ball : 0;
  }

  /** The lamp is where the frames have it: above, in front and to the left of where the scene is first seen from. */
  findLamp(up) {
    const {camera} = this.camera;
    const [right, , back] = [0, 1, 2].map(k => new THREE.Vector3().setFromMatrixColumn(camera.matrixWorld, k));
    return up.clone().addScaledVector(right, -0.35).addScaledVector(back, 0.75).normalize();
  }

  /** Lights what is seen now, and places the ground there. */
  shine() {
    const {lamp, camera: {controls: {target}}} = this, height = this.camera.seenHeight();
    const half = SHADOWS * height / 2;
    lamp.target.position.copy(target);
    lamp.position.copy(target).addScaledVector(this.towardsLamp, 2 * half);
    Object.assign(lamp.shadow.camera, {left: -half, right: half, bottom: -half, top: half, near: 0, far: 4 * half});
    lamp.shadow.camera.updateProjectionMatrix();
    this.renderer.shadowMap.needsUpdate = true;
    this.litHeight = height;
    this.grounds.forEach(ground => ground.place(target, height));
  }

  /** Whether the light is where somebody looked before zooming or moving the picture. */
  isLitElsewhere() {
    const zoom = this.camera.seenHeight() / this.litHeight;
    return Math.max(zoom, 1 / zoom) > ZOOM
        || this.camera.controls.target.distanceTo(this.lamp.target.position) > this.litHeight;
  }

  // ---- particles and springs that come and go ----

  setStructure(structure) {
    this.structure = structure;
    const {inSurface, hidden} = this, pairs = structure.springs, look = this.facts.look;
    this.isShown = structure.ids.map((id, i) => look.particles === 'always'
        || look.particles === 'beside_surfaces' && !inSurface.has(i));
    const isBeside = ([a, b]) => !(inSurface.has(a) && inSurface.has(b)) && !hidden.has(a) && !hidden.has(b);
    this.shownSprings = [...structure.restLengths.keys()].filter(s => look.springs === 'always'
        || look.springs === 'beside_surfaces' && isBeside(pairs.slice(2 * s, 2 * s + 2)));
    // without a graphics processor the triangles of many round balls would take a quarter of a second
    if (this.areMany !== structure.ids.length > FEW_BALLS) {
      this.areMany = !this.areMany;
      this.balls.setShape(new THREE.SphereGeometry(1, ...(this.areMany ? [8, 6] : [16, 12])));
    }
    if (this.pairs?.join() !== pairs.join()) {
      this.pairs = pairs;
      this.surfaces.forEach(surface => surface.tear(pairs));
    }
    this.setNames();
  }

  setNames() {
    this.marks.setLabels(this.structure?.ids ?? [], this.facts?.look.marks ?? {}, this.showNames);
    this.stale = true;
  }

  setLabels(on) {
    this.showNames = on;
    this.setNames();
    this.draw();                        // until then they have no place
  }

  setArrows(on) {
    this.showArrows = on;
    this.stale = true;
  }

  // ---- a moment ----

  show(moment) {
    this.moment = moment;
    this.trails?.add(moment.path, this.structure.ids);
    this.changed = this.stale = true;
  }

  place() {
    this.renderer.shadowMap.needsUpdate = true;
    const {state, time} = this.moment, {fixed, births, lives} = this.structure, look = this.facts.look;
    const wet = [];
    this.balls.clear();
    this.spots.clear();
    for (let i = 0; i < this.structure.ids.length; i++) {
      if (!this.isShown[i]) {
        continue;
      }
      if (look.kind === 'blobs' && !fixed[i]) {
        wet.push([...state.subarray(6 * i, 6 * i + 3)]);
        continue;
      }
      const mark = look.marks[this.structure.ids[i]];
      const size = this.radius(i);
      this.matrix.makeScale(size, size, size).setPosition(state[6 * i], state[6 * i + 1], state[6 * i + 2]);
      (look.kind === 'glow' && !fixed[i] ? this.spots : this.balls).add(this.matrix,
          this.structure.ids[i] === this.chosen ? this.colour.set(CHOSEN)
          : mark?.colour !== undefined ? this.colour.set(mark.colour)
          : this.particleColour(look, fixed[i], (time - births[i]) / lives[i]));
    }
    if (look.kind === 'blobs') {
      this.blobs.place(wet, this.ball, this.camera.viewHeight / this.element.clientHeight,
          this.camera.target.toArray());
    }
    this.surfaces.forEach(surface => surface.place(state));
    this.springs.place(state, this.structure, this.shownSprings, look.strainRange, this.shownBall(),
        this.camera.camera.getWorldDirection(new THREE.Vector3()).negate());
    if (this.trails.object.visible) {
      const {ids} = this.structure;
      this.trails.place(state, time, ids, ids.map(id => new THREE.Color(look.marks[id]?.colour ?? look.colours[0])),
          ids.map((id, i) => this.isShown[i] && !fixed[i] ? look.marks[id]?.trail ?? look.trail : 0));
    }
  }

  /** How large balls are (m): those of a run that fails stay visible when the picture holds all that flies away. */
  shownBall() {
    const smallest = this.camera.fails ? 4 * this.camera.viewHeight / this.element.clientHeight : 0;
    return Math.max(this.ball, smallest);
  }

  radius(i) {
    const {marks, kind} = this.facts.look, parts = this.structure.fixed[i] ? {glow: 1 / 3} : {points: 1 / 2};
    return marks[this.structure.ids[i]]?.radius || (parts[kind] ?? 1) * this.shownBall();
  }

  particleColour(look, isFixed, age) {
    if (look.kind !== 'glow' || isFixed) {
      return this.colour.set(look.colours[isFixed ? 1 : 0]);
    }
    const at = Math.max(0, Math.min(0.9999, age || 0)) * (look.ageColours.length - 1), k = Math.floor(at);
    const next = look.ageColours[Math.min(k + 1, look.ageColours.length - 1)];
    return this.colour.set(look.ageColours[k]).lerp(new THREE.Color(next), at - k)
        .multiplyScalar((1 - Math.min(1, age || 0)) ** 2.2);    // as much as 1 - age in the screen's colours
  }

  /** How far arrows reach (s): as the scene says, or so that the fastest since the start has a suitable length. */
  arrowSeconds() {
    if (!this.showArrows || this.facts.look.arrows > 0) {
      return this.showArrows ? this.facts.look.arrows : 0;
    }
    const state = this.moment.state;
    for (let i = 3; i < state.length; i += 6) {
      this.fastest = Math.max(this.fastest, Math.hypot(state[i], state[i + 1], state[i + 2]));
    }
    return this.fastest > 0 ? 0.12 * this.camera.viewHeight / this.fastest : 0;
  }

  // ---- the picture ----

  /** @returns whether it had changed */
  draw() {
    if (!this.stale || !this.moment || !this.scene) {
      return false;
    }
    if (this.changed) {
      this.place();
      this.camera.follow(this.moment.state, this.moment.slowed);
    }
    if (this.isLitElsewhere()) {
      this.shine();
    }
    this.stale = this.changed = false;
    this.renderer.render(this.scene, this.camera.camera);
    const {ids, fixed} = this.structure, pixels = this.element.clientHeight / this.camera.viewHeight;
    this.marks.draw((i, seconds) => this.onScreen(i, seconds), i => this.radius(i) * pixels + LABEL_GAP,
        [...ids.keys()].filter(i => !fixed[i]), this.arrowSeconds());
    const pulled = ids.indexOf(this.pull?.id);
    this.marks.drawPull(...pulled < 0 ? [] : [this.onScreen(pulled), this.camera.placeOf(this.pull.point)]);
    this.drawn?.();
    return true;
  }

  /** Where a particle is seen, or will be at its velocity; null behind the camera. */
  onScreen(i, seconds = 0) {
    return this.camera.placeOf(pointAhead(this.moment.state, i, seconds));
  }

  /** The particle that can move, or any, seen nearest to a place of the window, within so many pixels; else -1. */
  nearest({clientX, clientY}, reach, any) {
    const bounds = this.element.getBoundingClientRect();
    let nearest = -1, least = reach;
    this.structure?.ids.forEach((id, i) => {
      const [x, y] = this.onScreen(i) ?? [Infinity, Infinity];
      const distance = Math.hypot(x - clientX + bounds.left, y - clientY + bounds.top);
      if (distance < least && (any || !this.structure.fixed[i])) {
        [nearest, least] = [i, distance];
      }
    });
    return nearest;
  }

  /** The point under a place of the window that is as far away as a particle: coordinates (m). */
  pointUnder(place, particle) {
    return this.unproject(place, new THREE.Vector3().fromArray(this.moment.state, 6 * particle)
        .project(this.camera.camera).z);
  }

  unproject({clientX, clientY}, depth) {
    const bounds = this.element.getBoundingClientRect();
    return new THREE.Vector3(2 * (clientX - bounds.left) / bounds.width - 1,
        1 - 2 * (clientY - bounds.top) / bounds.height, depth).unproject(this.camera.camera).toArray();
  }

  /** The point under a place of the window in the plane x, y or z = the particles' mean that faces the camera most. */
  pointInPlane(place) {
    const from = this.unproject(place, -1), to = this.unproject(place, 1);
    const facing = this.camera.camera.getWorldDirection(new THREE.Vector3()).toArray().map(Math.abs);
    const axis = facing.indexOf(Math.max(...facing)), column = this.moment.state.filter((x, k) => k % 6 === axis);
    const mean = column.reduce((sum, x) => sum + x / column.length, 0);
    return from.map((x, k) => x + (to[k] - x) * (mean - from[axis]) / (to[axis] - from[axis]));
  }

  /** Marks a particle by its colour. */
  choose(id) {
    this.chosen = id;
    this.changed = this.stale = true;
  }

  /** Gives back what the graphics processor holds for it. */
  close() {
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  resize() {
    this.renderer.setSize(this.element.clientWidth, this.element.clientHeight);
    this.camera.resize();
    const dark = this.facts?.look.night || matchMedia('(prefers-color-scheme: dark)').matches;
    this.sky?.setColours(dark, this.facts.look.background);
    this.stale = true;
  }
}
