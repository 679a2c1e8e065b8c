// Lines between points that move: springs and rods, and the trails of particles.
import * as THREE from 'three';

const COMPRESSED = new THREE.Color(0x2166ac), AT_REST = new THREE.Color(0xc9c6c0);
const STRETCHED = new THREE.Color(0xc4161c), ROD = new THREE.Color(0x6c7683);
const MOST_COILS = 40, TRAIL_SAMPLES = 600, TRAIL_OPACITY = 0.85;
const Z = new THREE.Vector3(0, 0, 1), COIL = coil();

/** A spring along z from 0 to 1, of radius 1, thin enough when it is stretched along z. */
function coil() {
  const turns = 9, points = [];
  for (let k = 0; k <= turns * 12; k++) {
    const t = k / (turns * 12), inside = Math.min(t, 1 - t), r = Math.max(0, Math.min(1, (inside - 0.07) / 0.04));
    points.push(new THREE.Vector3(r * Math.cos(2 * Math.PI * turns * t), r * Math.sin(2 * Math.PI * turns * t), t));
  }
  return points;
}

/** Pairs of points joined by lines, each point with its own colour and opacity. */
class Lines {
  constructor() {
    this.object = new THREE.LineSegments(new THREE.BufferGeometry(),
        new THREE.LineBasicMaterial({vertexColors: true}));
    this.object.frustumCulled = false;
  }

  /** Replaces what is drawn; the memory grows and is used again. */
  set(positions, colours) {
    const geometry = this.object.geometry;
    for (const [name, values, size] of [['position', positions, 3], ['color', colours, 4]]) {
      if (!geometry.attributes[name] || geometry.attributes[name].array.length < values.length) {
        geometry.dispose();
        geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(2 * values.length + 2 * size), size));
      }
      geometry.attributes[name].array.set(values);
      geometry.attributes[name].needsUpdate = true;
    }
    geometry.setDrawRange(0, positions.length / 3);
  }
}

/** Springs coloured by their strain, drawn as coils where there are few; rods are straight and grey. */
export class Springs extends Lines {
  /** shown: the indices of the springs to be drawn */
  place(state, structure, shown, strainRange, radius) {
    const positions = [], colours = [], pairs = structure.springs;
    const a = new THREE.Vector3(), b = new THREE.Vector3(), p = new THREE.Vector3(), turn = new THREE.Quaternion();
    const asCoils = structure.restLengths.length <= MOST_COILS;
    for (const s of shown) {
      a.fromArray(state, 6 * pairs[2 * s]);
      b.fromArray(state, 6 * pairs[2 * s + 1]);
      const length = a.distanceTo(b), rest = structure.restLengths[s], rigid = structure.rigid[s];
      const colour = rigid ? ROD : strainColour(rest > 0 ? (length - rest) / rest / strainRange : 0);
      const from = positions.length;
      if (asCoils && !rigid && length > 0) {
        turn.setFromUnitVectors(Z, p.copy(b).sub(a).divideScalar(length));
        const points = COIL.map(q => new THREE.Vector3(radius * q.x, radius * q.y, length * q.z).applyQuaternion(turn)
            .add(a));
        for (let k = 1; k < points.length; k++) {
          positions.push(...points[k - 1].toArray(), ...points[k].toArray());
        }
      } else {
        positions.push(a.x, a.y, a.z, b.x, b.y, b.z);
      }
      for (let k = from; k < positions.length; k += 3) {
        colours.push(colour.r, colour.g, colour.b, 1);
      }
    }
    this.set(positions, colours);
  }
}

function strainColour(part) {
  return new THREE.Color().copy(AT_REST).lerp(part < 0 ? COMPRESSED : STRETCHED, Math.min(1, Math.abs(part)));
}

/** The paths that particles took in the last few seconds; they fade. */
export class Trails extends Lines {
  constructor() {
    super();
    this.object.material.transparent = true;
    this.samples = [];
  }

  /** colours: one a particle, null where it has no trail */
  place(state, time, ids, colours, duration) {
    const last = this.samples[this.samples.length - 1];
    if (last && time < last.time) {
      this.samples = [];
    }
    if (!last || time < last.time || time - last.time >= duration / TRAIL_SAMPLES) {
      this.samples.push({time, places: new Map(ids.map((id, i) => [id, [...state.subarray(6 * i, 6 * i + 3)]]))});
    }
    this.samples = this.samples.filter(sample => sample.time >= time - duration);
    const positions = [], faded = [];
    for (const [i, id] of ids.entries()) {
      let to = [...state.subarray(6 * i, 6 * i + 3)], toTime = time;
      for (let k = this.samples.length - 1; colours[i] && to && k >= 0; k--) {
        const from = this.samples[k].places.get(id), fromTime = this.samples[k].time;
        if (from) {
          positions.push(...from, ...to);
          for (const end of [fromTime, toTime]) {
            const {r, g, b} = colours[i];
            faded.push(r, g, b, TRAIL_OPACITY * (1 - (time - end) / duration));
          }
        }
        [to, toTime] = [from, fromTime];
      }
    }
    this.set(positions, faded);
  }
}
