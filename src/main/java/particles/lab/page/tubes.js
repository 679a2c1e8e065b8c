// Balls, spots and tubes that move: copies of one shape, drawn at once; springs, rods and wires made of them.
import * as THREE from 'three';
import {solid} from './sky.js';

const COMPRESSED = new THREE.Color(0x2166ac), AT_REST = new THREE.Color(0xc9c6c0);
const STRETCHED = new THREE.Color(0xc4161c), ROD = new THREE.Color(0x6c7683);
const MOST_COILS = 40, SOFT = 0.01;      // a spring is far softer below this part of the largest stiffness
const PIECES_OF_TURN = 10;
const STRAIGHT = 0.07, WIDE = 0.11;     // of a coil's length: a straight end; from where it has its full radius
// radii, in radii of balls
const TUBE = 0.3, RAILING = 0.2, BAR = 0.34, COIL = 0.62, COILED = 0.13;

/** Any number of copies of a shape, each with its own place and colour. */
export class Copies {
  constructor(geometry, material, castShadow = true) {
    Object.assign(this, {geometry, material, castShadow, object: new THREE.Group()});
    this.grow();
  }

  get count() {
    return this.mesh.count;
  }

  clear() {
    this.mesh.count = 0;
    this.object.visible = false;        // else its program would be compiled
  }

  setShape(geometry) {
    this.geometry.dispose();
    this.geometry = this.mesh.geometry = geometry;
  }

  add(matrix, colour) {
    if (this.count === this.mesh.instanceMatrix.count) {
      this.grow();
    }
    this.object.visible = true;
    this.mesh.setMatrixAt(this.count, matrix);
    this.mesh.setColorAt(this.mesh.count++, colour);
    this.mesh.instanceMatrix.needsUpdate = this.mesh.instanceColor.needsUpdate = true;
  }

  grow() {
    const old = this.mesh;
    this.mesh = new THREE.InstancedMesh(this.geometry, this.material, old ? 4 * old.count : 16);
    this.mesh.setColorAt(0, ROD);       // makes room for colours
    this.mesh.castShadow = this.castShadow;
    this.mesh.frustumCulled = false;
    this.mesh.count = old ? old.count : 0;
    if (old) {
      this.mesh.instanceMatrix.array.set(old.instanceMatrix.array);
      this.mesh.instanceColor.array.set(old.instanceColor.array);
      this.object.remove(old);
      old.dispose();
    }
    this.object.add(this.mesh);
  }
}

/** Straight tubes. */
class Tubes extends Copies {
  constructor() {
    super(new THREE.CylinderGeometry(1, 1, 1, 5, 1, true).translate(0, 0.5, 0), solid({}));
    Object.assign(this, {matrix: new THREE.Matrix4(), along: new THREE.Vector3(), across: new THREE.Vector3(),
      third: new THREE.Vector3()});
  }

  join(a, b, radius, colour) {
    const {matrix, along, across, third} = this;
    along.subVectors(b, a);
    across.set(0, 0, 0).setComponent(Math.abs(along.x) < 0.7 * along.length() ? 0 : 1, 1).cross(along)
        .setLength(radius);
    third.crossVectors(across, along).setLength(radius);
    this.add(matrix.makeBasis(across, along, third).setPosition(a), colour);
  }
}

/** A wire through points, whose coordinates are listed; ball: the radius of balls (m). */
export function wire(points, ball) {
  const tubes = new Tubes(), at = k => new THREE.Vector3().fromArray(points, k);
  for (let k = 3; k < points.length; k += 3) {
    tubes.join(at(k - 3), at(k), RAILING * ball, ROD);
  }
  return tubes.object;
}

/**
 * Springs coloured by their strain, as in the frames: as coils if they are few or far softer than the others. Rods, and
 * springs between fixed particles, are bars.
 */
export class Springs extends Tubes {
  /** stiffness: of all springs when the scene is opened (N/m); own: a colour instead of the strain's, or -1 */
  constructor({stiffness}, own) {
    super();
    this.own = own < 0 ? null : new THREE.Color(own);
    const soft = SOFT * stiffness.reduce((most, one) => one < Infinity ? Math.max(most, one) : most, 0);
    this.coilBelow = stiffness.length <= MOST_COILS ? Infinity
        : stiffness.filter(one => one > 0 && one < soft).length <= MOST_COILS ? soft : 0;
  }

  /** shown: the indices of the springs to be drawn; back: towards the viewer; ball: the radius of balls (m) */
  place(state, {springs, restLengths, stiffness, fixed}, shown, strainRange, ball, back) {
    const a = new THREE.Vector3(), b = new THREE.Vector3();
    this.clear();
    for (const s of shown) {
      const i = springs[2 * s], j = springs[2 * s + 1], rest = restLengths[s];
      a.fromArray(state, 6 * i);
      b.fromArray(state, 6 * j);
      const length = a.distanceTo(b), strain = rest > 0 ? (length - rest) / rest / strainRange : Math.sign(length);
      if (stiffness[s] === 0) {
        this.join(a, b, RAILING * ball, this.own ?? ROD);
      } else if (stiffness[s] === Infinity || fixed[i] && fixed[j]) {
        this.join(a, b, BAR * ball, ROD);
      } else if (stiffness[s] < this.coilBelow && rest > 0 && length > 4 * COILED * ball) {
        this.coil(a, b, rest, ball, this.own ?? strainColour(strain), back);
      } else {
        this.join(a, b, TUBE * ball, this.own ?? strainColour(strain));
      }
    }
  }

  /** The number of turns does not change with the length. */
  coil(a, b, rest, ball, colour, back) {
    const whole = b.clone().sub(a), along = whole.clone().normalize();
    const towards = Math.abs(along.dot(back)) > 0.999 ? along.clone().set(along.y, along.z, along.x) : back;
    const first = towards.clone().addScaledVector(along, -along.dot(towards)).normalize();
    const second = along.clone().cross(first);
    const turns = Math.max(4, Math.min(16, Math.round(rest / (1.5 * COIL * ball))));
    const from = a.clone(), to = new THREE.Vector3(), pieces = turns * PIECES_OF_TURN;
    for (let k = 1; k <= pieces; k++) {
      const t = k / pieces, inside = Math.min(t, 1 - t);
      const angle = 2 * Math.PI * turns * (t - STRAIGHT) / (1 - 2 * STRAIGHT);
      const radius = COIL * ball * Math.max(0, Math.min(1, (inside - STRAIGHT) / (WIDE - STRAIGHT)));
      to.copy(a).addScaledVector(whole, t).addScaledVector(first, radius * Math.cos(angle))
          .addScaledVector(second, radius * Math.sin(angle));
      this.join(from, to, COILED * ball, colour);
      from.copy(to);
    }
  }
}

function strainColour(part) {
  return new THREE.Color().copy(AT_REST).lerp(part < 0 ? COMPRESSED : STRETCHED, Math.min(1, Math.abs(part)));
}
