// The surface of a liquid, as in the frames: where the field of metaballs has a certain value, found by surface nets.
import * as THREE from 'three';
import {solid} from './sky.js';

const REACH = 2, LEVEL = (1 - 1 / REACH ** 2) ** 3;     // a single ball's surface is where its radius says
const FINEST = 4;                       // pixels; the frames have finer cells, and more time
const MIDDLE = 512, STEPS = [1 << 20, 1 << 10, 1];      // a node's key has three numbers of 10 bits
const CORNERS = [0, 1, 2, 3, 4, 5, 6, 7].map(corner => STEPS.map((step, axis) => (corner >> axis & 1) * step)
    .reduce((sum, step) => sum + step));

export class Blobs {
  constructor(color) {
    this.object = new THREE.Mesh(new THREE.BufferGeometry(), solid({color}, 1.6));
    this.object.frustumCulled = false;
    this.object.castShadow = true;
  }

  /** The surface of balls of a radius (m) around points; a pixel at the origin is so wide (m). */
  place(points, radius, pixel, origin) {
    const cell = Math.min(Math.max(radius / 2, FINEST * pixel), 0.7 * radius);
    Object.assign(this, {cell, numbers: new Map(), sums: [], cells: new Map(), places: []});
    for (const point of points) {
      this.add(point.map((x, axis) => (x - origin[axis]) / cell + MIDDLE), REACH * radius / cell);
    }
    const corners = [];
    for (const [key, at] of this.numbers) {
      for (let axis = 0; this.sums[at] >= LEVEL && axis < 3; axis++) {
        if (!this.isInside(key + STEPS[axis])) {
          this.join(corners, key, axis, true);
        }
        if (!this.isInside(key - STEPS[axis])) {
          this.join(corners, key - STEPS[axis], axis, false);
        }
      }
    }
    const {geometry} = this.object;
    geometry.dispose();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(this.places.map((x, i) =>
        (x - MIDDLE) * cell + origin[i % 3]), 3));
    geometry.setIndex(corners);
    geometry.deleteAttribute('normal');         // there were fewer or more
    geometry.computeVertexNormals();
  }

  /** Adds a ball's field to the nodes nearer than its reach; lengths are in cells from now on. */
  add([x, y, z], reach) {
    if (![x, y, z].every(value => value > reach + 1 && value < 2 * MIDDLE - reach - 2)) {
      return;                           // out of the picture
    }
    const {numbers, sums} = this, square = reach * reach;
    for (let i = Math.ceil(x - reach); i <= x + reach; i++) {
      for (let j = Math.ceil(y - reach); j <= y + reach; j++) {
        for (let k = Math.ceil(z - reach); k <= z + reach; k++) {
          const rest = 1 - ((i - x) ** 2 + (j - y) ** 2 + (k - z) ** 2) / square;
          if (rest > 0) {
            const key = i * STEPS[0] + j * STEPS[1] + k;
            let at = numbers.get(key);
            if (at === undefined) {
              numbers.set(key, at = sums.length);
              sums.push(0);
            }
            sums[at] += rest ** 3;
          }
        }
      }
    }
  }

  isInside(key) {
    return this.sums[this.numbers.get(key)] >= LEVEL;
  }

  /** The four cells around an edge that the surface crosses, as two triangles. */
  join(corners, edge, axis, outwards) {
    const b = STEPS[(axis + 1) % 3], c = STEPS[(axis + 2) % 3];
    const quad = [edge, edge - b, edge - b - c, edge - c].map(cell => this.vertex(cell));
    const [p, q, r, s] = outwards ? quad : quad.reverse();
    corners.push(p, q, r, p, r, s);
  }

  /** A cell's vertex: the mean of where the surface crosses its edges. */
  vertex(cell) {
    const known = this.cells.get(cell), place = [0, 0, 0];
    if (known !== undefined) {
      return known;
    }
    const values = CORNERS.map(corner => this.sums[this.numbers.get(cell + corner)] ?? 0);
    let crossings = 0;
    for (let corner = 0; corner < 8; corner++) {
      for (let axis = 0; axis < 3; axis++) {
        const low = values[corner], high = values[corner | 1 << axis];
        if (low >= LEVEL !== high >= LEVEL) {
          place.forEach((sum, k) => { place[k] += (corner >> k & 1) + (k === axis) * (LEVEL - low) / (high - low); });
          crossings++;
        }
      }
    }
    const base = [cell >> 20, cell >> 10 & 1023, cell & 1023];
    this.cells.set(cell, this.places.length / 3);
    this.places.push(...place.map((sum, axis) => base[axis] + sum / crossings));
    return this.places.length / 3 - 1;
  }
}
