// What does not move: planes, balls and wires.
import * as THREE from 'three';

const WIRE = 0x6c7683;

/** @returns the things to draw; planes are centred on the target, many times the extent wide */
export function scenery(facts, target, extent) {
  return [...facts.planes.map(plane => ground(plane, target, extent)), ...facts.spheres.map(ball),
    ...facts.wires.map(wire)];
}

function ground(plane, target, extent) {
  const size = 60 * extent, group = new THREE.Group();
  const mesh = new THREE.Mesh(new THREE.PlaneGeometry(size, size), new THREE.MeshLambertMaterial({color: 0x9aa6b2,
    side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1}));
  const grid = new THREE.GridHelper(12 * extent, 24, 0x6d7884, 0x7f8b97);
  grid.rotation.x = Math.PI / 2;
  group.add(mesh, grid);
  const normal = new THREE.Vector3(...plane.normal).normalize(), point = new THREE.Vector3(...plane.point);
  group.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), normal);
  group.position.copy(target).addScaledVector(normal, -normal.dot(target.clone().sub(point)));
  return group;
}

function ball({centre, radius, hollow}) {
  const mesh = new THREE.Mesh(new THREE.SphereGeometry(radius, 48, 32), new THREE.MeshLambertMaterial({
    color: 0x8fa3b8, side: hollow ? THREE.BackSide : THREE.FrontSide, transparent: hollow,
    opacity: hollow ? 0.5 : 1}));
  mesh.position.set(...centre);
  return mesh;
}

function wire(points) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(points, 3));
  return new THREE.Line(geometry, new THREE.LineBasicMaterial({color: WIRE}));
}
