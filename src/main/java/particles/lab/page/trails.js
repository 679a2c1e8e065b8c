// The trails of particles.
import * as THREE from 'three';

const TRAIL_SAMPLES = 600, TRAIL_OPACITY = 0.85;

/** The paths that particles took in the last few seconds; they fade. */
export class Trails {
  constructor() {
    this.object = new THREE.LineSegments(new THREE.BufferGeometry(),
        new THREE.LineBasicMaterial({vertexColors: true, transparent: true}));
    this.object.frustumCulled = false;
    this.samples = [];
    this.duration = 0;
  }

  /** path: after each step, the time and the state of the particles with these names */
  add(path, ids) {
    for (let r = 0; r < path.length; r += 1 + 6 * ids.length) {
      const time = path[r];
      if (time <= this.samples.at(-1)?.time) {          // the run began anew
        this.samples = this.samples.filter(sample => sample.time < time);
      }
      if (!(time - this.samples.at(-1)?.time < this.duration / TRAIL_SAMPLES)) {
        this.samples.push({time, places: new Map(ids.map((id, i) =>
            [id, [...path.subarray(r + 1 + 6 * i, r + 4 + 6 * i)]]))});
      }
    }
  }

  /** colours and durations: one a particle; the duration is 0 where it has no trail */
  place(state, time, ids, colours, durations) {
    this.duration = Math.max(0, ...durations);
    this.samples = this.samples.filter(sample => sample.time >= this.samples.at(-1).time - this.duration);
    const past = this.samples.filter(sample => sample.time < time), positions = [], faded = [];
    for (const [i, id] of ids.entries()) {
      let to = [...state.subarray(6 * i, 6 * i + 3)], toTime = time;
      for (let k = past.length - 1; to && time - toTime < durations[i] && k >= 0; k--) {
        const from = past[k].places.get(id), fromTime = past[k].time;
        if (from) {
          positions.push(...from, ...to);
          for (const end of [fromTime, toTime]) {
            const {r, g, b} = colours[i];
            faded.push(r, g, b, TRAIL_OPACITY * Math.max(0, 1 - (time - end) / durations[i]));
          }
        }
        [to, toTime] = [from, fromTime];
      }
    }
    const {geometry} = this.object;
    geometry.dispose();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
    geometry.setAttribute('color', new THREE.Float32BufferAttribute(faded, 4));
  }
}
