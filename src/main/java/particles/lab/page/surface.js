// A surface spanned by particles, as in the frames: a colour for each side, smooth where it is not creased.
import * as THREE from 'three';
import {solid} from './sky.js';

const SMOOTH = 0.85;                    // the cosine between a triangle's normal and the mean, from which it is smooth
const GLOSS = 0.35;

/** An edge, with its direction. */
const keyOf = (a, b) => 2 ** 26 * a + b;

/** The indices of the corners of closed surfaces: each edge is also one of another triangle, in the other direction. */
export const cornersOfClosed = surfaces => new Set(surfaces.map(surface => surface.triangles).filter(triangles => {
  const edges = edgesOf(triangles), all = new Set(edges.map(([a, b]) => keyOf(a, b)));
  return edges.every(([a, b]) => all.has(keyOf(b, a)));
}).flat());

const edgesOf = triangles => triangles.map((a, k) => [a, triangles[k % 3 === 2 ? k - 2 : k + 1]]);

export class Surface {
  /** colours: of the front and of the back */
  constructor({triangles, ofSprings}, colours) {
    Object.assign(this, {triangles, ofSprings, geometry: new THREE.BufferGeometry(), object: new THREE.Group()});
    for (const [k, side] of [THREE.FrontSide, THREE.BackSide].entries()) {
      const mesh = new THREE.Mesh(this.geometry, solid({color: colours[k], side}, GLOSS));
      mesh.frustumCulled = false;
      mesh.castShadow = true;
      this.object.add(mesh);
    }
  }

  /** A triangle of springs that keeps fewer than two of them is torn. pairs: the ends of the springs that are left */
  tear(pairs) {
    const held = new Set();
    for (let k = 0; this.ofSprings && k < pairs.length; k += 2) {
      held.add(keyOf(pairs[k], pairs[k + 1])).add(keyOf(pairs[k + 1], pairs[k]));
    }
    const edges = edgesOf(this.triangles).map(([a, b]) => held.has(keyOf(a, b)));
    this.kept = this.triangles.filter((a, k) => {
      const t = k - k % 3;
      return !this.ofSprings || edges[t] + edges[t + 1] + edges[t + 2] >= 2;
    });
    this.geometry.dispose();
    for (const name of ['position', 'normal']) {
      this.geometry.setAttribute(name, new THREE.Float32BufferAttribute(3 * this.kept.length, 3));
    }
  }

  /** Each corner has the mean normal of the triangles around or, where that is far from it, its own triangle's. */
  place(state) {
    const {kept, geometry: {attributes: {position, normal}}} = this;
    const [a, b, c, own] = [0, 1, 2, 3].map(() => new THREE.Vector3()), smooth = [], normals = [];
    for (let k = 0; k < kept.length; k += 3) {
      [a, b, c].forEach((corner, i) => corner.fromArray(state, 6 * kept[k + i]).toArray(position.array, 3 * (k + i)));
      own.subVectors(c, b).cross(a.sub(b));
      for (const corner of kept.slice(k, k + 3)) {
        (smooth[corner] ??= new THREE.Vector3()).add(own);
      }
      normals.push(own.clone().normalize());
    }
    smooth.forEach(sum => sum.normalize());
    kept.forEach((corner, k) => {
      const flat = normals[Math.floor(k / 3)];
      (flat.dot(smooth[corner]) >= SMOOTH ? smooth[corner] : flat).toArray(normal.array, 3 * k);
    });
    position.needsUpdate = normal.needsUpdate = true;
  }
}
