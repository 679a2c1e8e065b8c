// The chosen particle: its mass, place, velocity and the forces on it, in numbers and as arrows.
import {$, few, make} from './dom.js';

const INTERVAL = 150;                   // milliseconds between two questions
const SVG = 'http://www.w3.org/2000/svg', LONGEST = 0.16;       // of the picture's height
const COLOURS = {gravity: '#009e73', springs: '#cc79a7', pointer: '#e69f00'}, OTHER = '#0072b2';
const digits = value => few(value, 3);
const vector = values => '(' + [...values].map(digits).join(', ') + ')';

export class Inspector {
  /** element: the picture; ask(id): asks for the forces on a particle, which are then shown */
  constructor(element, ask) {
    Object.assign(this, {ask, asked: 0, forces: {}, largest: 0});
    this.drawing = document.createElementNS(SVG, 'svg');
    this.drawing.setAttribute('class', 'forces');
    element.append(this.drawing);
  }

  start() {
    Object.assign(this, {forces: {}, largest: 0, asked: 0});
  }

  /** A moment of the particle with index i; the forces of earlier moments are not kept. */
  show(id, state, i, past) {
    const now = performance.now();
    $('place').textContent = vector(state.subarray(6 * i, 6 * i + 3)) + ' m';
    $('velocity').textContent = vector(state.subarray(6 * i + 3, 6 * i + 6)) + ' m/s';
    if (past || id !== this.id) {
      this.tell({});
    }
    this.id = id;
    if (!past && now - this.asked > INTERVAL) {
      this.asked = now;
      this.ask(id);
    }
  }

  /** What the compiled classes answer: the mass and the forces by name. */
  answer({id, mass, forces}) {
    if (id === this.id) {
      $('mass').textContent = mass === undefined ? '' : digits(mass) + ' kg';
      this.tell(forces ?? {});
    }
  }

  tell(forces) {
    this.forces = forces;
    const names = Object.keys(forces);
    $('forceList').replaceChildren(...names.map(name =>
        make('li', {textContent: name + ' ' + vector(forces[name]) + ' N'})));
  }

  /** place(point) is where a point is seen; from is the particle's place, height that of the picture (m) */
  draw(place, from, height, on) {
    const lengths = Object.values(this.forces).map(force => Math.hypot(...force));
    this.largest = Math.max(this.largest, ...lengths);
    this.drawing.replaceChildren(...(on && from ? Object.entries(this.forces) : []).flatMap(([name, force]) => {
      const metres = LONGEST * height / this.largest;
      const start = place(from), end = place(from.map((value, c) => value + metres * force[c]));
      return start && end ? arrow(start, end, name) : [];
    }));
  }
}

function arrow([x0, y0], [x1, y1], name) {
  const length = Math.hypot(x1 - x0, y1 - y0), colour = COLOURS[name] ?? OTHER;
  if (length < 3) {
    return [];
  }
  const [ex, ey] = [(x1 - x0) / length, (y1 - y0) / length], head = Math.min(12, length);
  const line = document.createElementNS(SVG, 'path');
  line.setAttribute('d', `M${x0} ${y0}L${x1} ${y1}M${x1 - head * ex - 0.4 * head * ey} ${y1 - head * ey
      + 0.4 * head * ex}L${x1} ${y1}L${x1 - head * ex + 0.4 * head * ey} ${y1 - head * ey - 0.4 * head * ex}`);
  line.setAttribute('stroke', colour);
  const label = document.createElementNS(SVG, 'text');
  label.setAttribute('x', x1 + 4);
  label.setAttribute('y', y1 - 4);
  label.textContent = name;
  return [line, label];
}
