// The scene in three dimensions, drawn as in the frames: springs by strain, surfaces, planes, balls, rods, wires.
import * as THREE from 'three';
import {OrbitControls} from 'orbit';

const COMPRESSED = new THREE.Color(0x2166ac), AT_REST = new THREE.Color(0xc9c6c0);
const STRETCHED = new THREE.Color(0xc4161c), ROD = new THREE.Color(0x6c7683);
const MOST_COILS = 40, MOST_NAMES = 60, TRAIL_SAMPLES = 120;
const Z = new THREE.Vector3(0, 0, 1);

/** A spring along z from 0 to 1, of radius 1, thin enough when it is stretched along z. */
function coil() {
  const turns = 9, points = [];
  for (let k = 0; k <= turns * 12; k++) {
    const t = k / (turns * 12), inside = Math.min(t, 1 - t), r = Math.max(0, Math.min(1, (inside - 0.07) / 0.04));
    points.push(new THREE.Vector3(r * Math.cos(2 * Math.PI * turns * t), r * Math.sin(2 * Math.PI * turns * t), t));
  }
  return points;
}

/** The picture; where the browser cannot draw one, a line that says so. */
export function makeView(element, pick) {
  return document.createElement('canvas').getContext('webgl2') ? new View(element, pick) : new NoPicture(element);
}

class NoPicture {
  constructor(element) {
    element.textContent = 'No picture: this browser has no WebGL 2. Plots, numbers and the editor work.';
  }

  open(facts) {
    this.facts = facts;
  }

  setStructure() {}
  setLabels() {}
  setArrows() {}
  show() {}
  draw() {}
  resize() {}
}

class View {
  constructor(element, pick) {
    this.element = element;
    this.renderer = new THREE.WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    element.append(this.renderer.domElement);
    this.camera = new THREE.PerspectiveCamera(35, 1, 0.01, 1000);
    this.names = [];
    this.matrix = new THREE.Matrix4();
    this.colour = new THREE.Color();
    let down = null;
    element.addEventListener('pointerdown', event => { down = [event.clientX, event.clientY]; });
    element.addEventListener('pointerup', event => {
      if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4) {
        this.pickAt(event, pick);
      }
    });
    element.addEventListener('keydown', event => this.turnByKey(event));
    this.resize();
  }

  // ---- a new scene ----

  open(facts, structure, state) {
    this.facts = facts;
    this.scene?.traverse(thing => { thing.geometry?.dispose(); thing.material?.dispose(); });
    this.scene = new THREE.Scene();
    this.trail = [];
    this.fastest = 0;
    this.frame(facts, structure, state);
    const sun = new THREE.DirectionalLight(0xffffff, 2.2);
    sun.position.set(0.4, 1, 0.7);
    this.scene.add(sun, new THREE.HemisphereLight(0xffffff, 0x8894a5, 1.6));
    this.addScenery(facts);
    this.balls = this.instances(new THREE.SphereGeometry(1, 16, 12), structure.ids.length);
    this.coils = this.segments({vertexColors: true});
    this.lines = this.segments({vertexColors: true});
    this.velocities = this.segments({color: 0x009e73});
    this.surfaces = facts.surfaces.map(surface => this.addSurface(surface, facts.look));
    this.resize();
  }

  segments(look) {
    const lines = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial(look));
    lines.frustumCulled = false;
    this.scene.add(lines);
    return lines;
  }

  instances(geometry, count, material = new THREE.MeshStandardMaterial({roughness: 0.6})) {
    const mesh = new THREE.InstancedMesh(geometry, material, Math.max(16, count));
    mesh.frustumCulled = false;
    mesh.count = 0;
    this.scene.add(mesh);
    return mesh;
  }

  /** The scene's camera, or one that shows all particles; with gravity, also where they can swing from fixed ones. */
  frame(facts, structure, state) {
    const box = new THREE.Box3(), pegs = new THREE.Box3(), point = new THREE.Vector3();
    for (let i = 0; i < structure.ids.length; i++) {
      box.expandByPoint(point.set(state[6 * i], state[6 * i + 1], state[6 * i + 2]));
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
        reach = Math.max(reach, middle.distanceTo(point.set(state[6 * i], state[6 * i + 1], state[6 * i + 2])));
      }
      box.expandByPoint(middle.clone().add(new THREE.Vector3(reach, 0, 0)));
      box.expandByPoint(middle.clone().sub(new THREE.Vector3(reach, reach, 0)));
    }
    if (box.isEmpty()) {
      box.setFromCenterAndSize(new THREE.Vector3(), new THREE.Vector3(2, 2, 2));
    }
    const sphere = box.getBoundingSphere(new THREE.Sphere());
    this.extent = Math.max(1e-6, sphere.radius);
    const given = facts.camera;
    const aspect = this.camera.aspect;
    this.camera.fov = given?.perspective ? given.fieldOfView : 35;
    const half = Math.tan(this.camera.fov * Math.PI / 360);
    this.target = given ? new THREE.Vector3(...given.target) : sphere.center.clone();
    const flat = box.max.z - box.min.z < 0.05 * this.extent;
    const from = given ? new THREE.Vector3(...given.position).sub(this.target)
        : (flat ? new THREE.Vector3(0.22, 0.16, 1) : new THREE.Vector3(0.55, 0.42, 1));
    const distance = !given ? 1.15 * this.extent / Math.sin(Math.atan(half * Math.min(1, aspect)))
        : given.perspective ? from.length() * Math.max(1, 1.5 / aspect) : given.height / 2 / half;
    this.camera.up.set(...(given?.up ?? [0, 1, 0]));
    this.camera.near = distance / 1000;
    this.camera.far = distance * 100;
    this.camera.position.copy(this.target).addScaledVector(from.normalize(), distance);
    this.viewHeight = 2 * distance * half;
    this.controls?.dispose();
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.target.copy(this.target);
    this.controls.addEventListener('change', () => { this.stale = true; });
    this.controls.update();
  }

  addScenery(facts) {
    for (const plane of facts.planes) {
      const size = 60 * this.extent;
      const ground = new THREE.Group();
      const mesh = new THREE.Mesh(new THREE.PlaneGeometry(size, size), new THREE.MeshStandardMaterial({color: 0x9aa6b2,
        roughness: 1, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1}));
      const grid = new THREE.GridHelper(12 * this.extent, 24, 0x6d7884, 0x7f8b97);
      grid.rotation.x = Math.PI / 2;
      ground.add(mesh, grid);
      ground.quaternion.setFromUnitVectors(Z, new THREE.Vector3(...plane.normal).normalize());
      const normal = new THREE.Vector3(...plane.normal).normalize();
      const point = new THREE.Vector3(...plane.point);
      ground.position.copy(this.target).addScaledVector(normal, -normal.dot(this.target.clone().sub(point)));
      this.scene.add(ground);
    }
    for (const ball of facts.spheres) {
      const mesh = new THREE.Mesh(new THREE.SphereGeometry(ball.radius, 48, 32), new THREE.MeshStandardMaterial({
        color: 0x8fa3b8, roughness: 0.7, side: ball.hollow ? THREE.BackSide : THREE.FrontSide, transparent: ball.hollow,
        opacity: ball.hollow ? 0.5 : 1}));
      mesh.position.set(...ball.centre);
      this.scene.add(mesh);
    }
    for (const wire of facts.wires) {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute('position', new THREE.Float32BufferAttribute(wire, 3));
      this.scene.add(new THREE.Line(geometry, new THREE.LineBasicMaterial({color: ROD})));
    }
  }

  addSurface(surface, look) {
    const geometry = new THREE.BufferGeometry();
    const sides = [[look.colours[2], THREE.FrontSide], [look.colours[3], THREE.BackSide]];
    for (const [color, side] of sides) {
      const mesh = new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({color, side, roughness: 0.8}));
      mesh.frustumCulled = false;
      this.scene.add(mesh);
    }
    return {surface, geometry};
  }

  // ---- particles and springs that come and go ----

  setStructure(structure) {
    this.structure = structure;
    const count = structure.ids.length, pairs = structure.springs, look = this.facts.look;
    const inSurface = new Set(this.facts.surfaces.flatMap(surface => surface.triangles));
    this.isShown = structure.ids.map((id, i) => look.particles === 'always'
        || look.particles === 'beside_surfaces' && !inSurface.has(i));
    this.shownSprings = structure.restLengths.map((length, s) => s).filter(s => look.springs === 'always'
        || look.springs === 'beside_surfaces' && !(inSurface.has(pairs[2 * s]) && inSurface.has(pairs[2 * s + 1])));
    const mean = structure.restLengths.reduce((sum, length) => sum + length / structure.restLengths.length, 0);
    this.ball = look.radius || Math.min(this.viewHeight * Math.min(0.028, 0.3 / Math.cbrt(Math.max(1, count))),
        mean > 0 ? 0.26 * mean : Infinity);
    if (count > this.balls.instanceMatrix.count) {
      this.scene.remove(this.balls);
      this.balls.dispose();
      this.balls = this.instances(this.balls.geometry, 2 * count, this.balls.material);
    }
    if (look.kind === 'glow') {
      Object.assign(this.balls.material, {transparent: true, blending: THREE.AdditiveBlending, depthWrite: false});
    }
    this.asCoils = structure.restLengths.length <= MOST_COILS;
    this.setTriangles();
    this.setNames();
  }

  /** A triangle of springs that keeps fewer than two of them is torn. */
  setTriangles() {
    const pairs = this.structure.springs, edges = new Set();
    for (let s = 0; s < pairs.length; s += 2) {
      edges.add(pairs[s] + ' ' + pairs[s + 1]).add(pairs[s + 1] + ' ' + pairs[s]);
    }
    for (const {surface, geometry} of this.surfaces) {
      const kept = [];
      for (let t = 0; t < surface.triangles.length; t += 3) {
        const [a, b, c] = surface.triangles.slice(t, t + 3);
        const held = edges.has(a + ' ' + b) + edges.has(b + ' ' + c) + edges.has(c + ' ' + a);
        if (!surface.ofSprings || held >= 2) {
          kept.push(a, b, c);
        }
      }
      geometry.setIndex(kept);
      geometry.setAttribute('position', new THREE.Float32BufferAttribute(3 * this.structure.ids.length, 3));
    }
  }

  setNames() {
    this.names.splice(0).forEach(name => name.remove());
    if (!this.showNames) {
      return;
    }
    for (const id of this.structure.ids.slice(0, MOST_NAMES)) {
      const name = document.createElement('span');
      name.className = 'name';
      name.textContent = id;
      this.element.append(name);
      this.names.push(name);
    }
  }

  setLabels(on) {
    this.showNames = on;
    this.setNames();
    this.stale = true;
  }

  setArrows(on) {
    this.showArrows = on;
    this.show(this.moment);
  }

  // ---- a moment ----

  show(moment) {
    this.moment = moment;
    this.changed = this.stale = true;
  }

  place() {
    const {state, time} = this.moment, {fixed, births, lives} = this.structure, look = this.facts.look;
    let shown = 0;
    for (let i = 0; i < this.structure.ids.length; i++) {
      if (!this.isShown[i]) {
        continue;
      }
      const mark = look.marks[this.structure.ids[i]];
      const size = mark?.radius || (look.kind === 'points' ? 0.5 * this.ball : this.ball);
      this.matrix.makeScale(size, size, size).setPosition(state[6 * i], state[6 * i + 1], state[6 * i + 2]);
      this.balls.setMatrixAt(shown, this.matrix);
      this.balls.setColorAt(shown, mark?.colour !== undefined ? this.colour.set(mark.colour)
          : this.particleColour(look, fixed[i], (time - births[i]) / (lives[i] ?? Infinity)));
      shown++;
    }
    this.balls.count = shown;
    this.balls.instanceMatrix.needsUpdate = true;
    if (this.balls.instanceColor) {
      this.balls.instanceColor.needsUpdate = true;
    }
    for (const {geometry} of this.surfaces) {
      const positions = geometry.attributes.position;
      for (let i = 0; i < this.structure.ids.length; i++) {
        positions.setXYZ(i, state[6 * i], state[6 * i + 1], state[6 * i + 2]);
      }
      positions.needsUpdate = true;
      geometry.computeVertexNormals();
    }
    this.placeSprings(state);
    this.placeTrails(state, time);
    this.placeArrows(state);
  }

  particleColour(look, isFixed, age) {
    if (look.kind !== 'glow' || isFixed) {
      return this.colour.set(look.colours[isFixed ? 1 : 0]);
    }
    const at = Math.max(0, Math.min(0.9999, age || 0)) * (look.ageColours.length - 1), k = Math.floor(at);
    const next = look.ageColours[Math.min(k + 1, look.ageColours.length - 1)];
    return this.colour.set(look.ageColours[k]).lerp(new THREE.Color(next), at - k).multiplyScalar(1 - 0.8 * (age || 0));
  }

  placeSprings(state) {
    const positions = [], colours = [], pairs = this.structure.springs;
    const a = new THREE.Vector3(), b = new THREE.Vector3(), p = new THREE.Vector3(), turn = new THREE.Quaternion();
    const shape = this.asCoils ? coil() : null;
    for (const s of this.shownSprings) {
      a.fromArray(state, 6 * pairs[2 * s]);
      b.fromArray(state, 6 * pairs[2 * s + 1]);
      const length = a.distanceTo(b), rest = this.structure.restLengths[s], rigid = this.structure.rigid[s];
      const colour = rigid ? ROD : this.strainColour(rest > 0 ? (length - rest) / rest : 0);
      const from = positions.length;
      if (shape && !rigid && length > 0) {
        turn.setFromUnitVectors(Z, p.copy(b).sub(a).divideScalar(length));
        const r = 0.62 * this.ball;
        const points = shape.map(q => new THREE.Vector3(r * q.x, r * q.y, length * q.z).applyQuaternion(turn).add(a));
        for (let k = 1; k < points.length; k++) {
          positions.push(...points[k - 1].toArray(), ...points[k].toArray());
        }
      } else {
        positions.push(a.x, a.y, a.z, b.x, b.y, b.z);
      }
      for (let k = from; k < positions.length; k += 3) {
        colours.push(colour.r, colour.g, colour.b);
      }
    }
    set(this.coils.geometry, positions, colours);
  }

  strainColour(strain) {
    const part = strain / this.facts.look.strainRange;
    const full = part < 0 ? COMPRESSED : STRETCHED;
    return new THREE.Color().copy(AT_REST).lerp(full, Math.min(1, Math.abs(part)));
  }

  placeTrails(state, time) {
    const duration = this.facts.look.trail, positions = [], colours = [];
    if (duration > 0) {
      const ids = this.structure.ids;
      const last = this.trail[this.trail.length - 1];
      if (last && time < last.time) {
        this.trail = [];
      }
      if (!last || time - last.time >= duration / TRAIL_SAMPLES) {
        this.trail.push({time, places: new Map(ids.map((id, i) => [id, [...state.subarray(6 * i, 6 * i + 3)]]))});
      }
      this.trail = this.trail.filter(sample => sample.time >= time - duration);
      const {colours: [usual], marks} = this.facts.look;
      const byParticle = ids.map(id => new THREE.Color(marks[id]?.colour ?? usual));
      for (let k = 1; k < this.trail.length; k++) {
        for (const [i, id] of ids.entries()) {
          const colour = byParticle[i];
          const from = this.trail[k - 1].places.get(id), to = this.trail[k].places.get(id);
          if (from && to && !this.structure.fixed[i]) {
            positions.push(...from, ...to);
            colours.push(colour.r, colour.g, colour.b, colour.r, colour.g, colour.b);
          }
        }
      }
    }
    set(this.lines.geometry, positions, colours);
  }

  placeArrows(state) {
    const positions = [];
    if (this.showArrows) {
      let fastest = 0;
      for (let i = 0; i < this.structure.ids.length; i++) {
        fastest = Math.max(fastest, Math.hypot(state[6 * i + 3], state[6 * i + 4], state[6 * i + 5]));
      }
      this.fastest = Math.max(this.fastest, fastest);           // since the start, so that lengths can be compared
      const scale = this.fastest > 0 ? 0.12 * this.viewHeight / this.fastest : 0;
      for (let i = 0; i < this.structure.ids.length; i++) {
        for (const end of [0, scale]) {
          positions.push(state[6 * i] + end * state[6 * i + 3], state[6 * i + 1] + end * state[6 * i + 4],
              state[6 * i + 2] + end * state[6 * i + 5]);
        }
      }
    }
    set(this.velocities.geometry, positions);
  }

  // ---- the picture ----

  draw() {
    if (!this.stale || !this.moment || !this.scene) {
      return;
    }
    if (this.changed) {
      this.place();
    }
    this.stale = this.changed = false;
    this.renderer.render(this.scene, this.camera);
    this.names.forEach((name, i) => {
      const [x, y] = this.onScreen(i);
      name.style.transform = `translate(${x + 8}px, ${y - 8}px)`;
    });
  }

  onScreen(i) {
    const p = new THREE.Vector3().fromArray(this.moment.state, 6 * i).project(this.camera);
    return [(p.x + 1) / 2 * this.element.clientWidth, (1 - p.y) / 2 * this.element.clientHeight];
  }

  pickAt(event, pick) {
    const bounds = this.element.getBoundingClientRect();
    let nearest = -1, least = 24;
    this.structure?.ids.forEach((id, i) => {
      const [x, y] = this.onScreen(i);
      const distance = Math.hypot(x - event.clientX + bounds.left, y - event.clientY + bounds.top);
      if (distance < least && !this.structure.fixed[i]) {
        [nearest, least] = [i, distance];
      }
    });
    if (nearest >= 0) {
      pick(this.structure.ids[nearest]);
    }
  }

  turnByKey(event) {
    const turns = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]};
    const nearer = {'+': 0.9, '=': 0.9, '-': 1 / 0.9}[event.key];
    if (!this.controls || !turns[event.key] && !nearer) {
      return;
    }
    event.preventDefault();
    const offset = new THREE.Spherical().setFromVector3(this.camera.position.clone().sub(this.controls.target));
    const [theta, phi] = turns[event.key] ?? [0, 0];
    offset.theta += theta;
    offset.phi = Math.max(0.01, Math.min(Math.PI - 0.01, offset.phi + phi));
    offset.radius *= nearer ?? 1;
    this.camera.position.setFromSpherical(offset).add(this.controls.target);
    this.controls.update();
  }

  resize() {
    const width = this.element.clientWidth, height = this.element.clientHeight;
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.renderer.setSize(width, height);
    const dark = this.facts?.look.night || matchMedia('(prefers-color-scheme: dark)').matches;
    if (this.scene) {
      this.scene.background = new THREE.Color(dark ? 0x0d1117 : 0xdfe7ef);
    }
    this.stale = true;
  }
}

/** Replaces what lines are drawn; their memory grows and is used again. */
function set(geometry, positions, colours) {
  for (const [name, values] of [['position', positions], ['color', colours]]) {
    if (!values) {
      continue;
    }
    if (!geometry.attributes[name] || geometry.attributes[name].array.length < values.length) {
      geometry.dispose();
      geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(2 * values.length + 6), 3));
    }
    geometry.attributes[name].array.set(values);
    geometry.attributes[name].needsUpdate = true;
  }
  geometry.setDrawRange(0, positions.length / 3);
}
