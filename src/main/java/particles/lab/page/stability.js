// The stability region of the chosen method, and in it h lambda of the scene's stiffest vibration as deltaT changes.
import {$, few, ink} from './dom.js';

const WINDOW = {left: -5, bottom: 0, cell: 0.125, columns: 56, rows: 32};
const RIGHT = WINDOW.left + WINDOW.cell * WINDOW.columns, TOP = WINDOW.cell * WINDOW.rows;
const ROUNDING = 1e-8;                  // what grows less is round-off or Newton's tolerance
const digits = number => few(number, 3);

export class Stability {
  /** engine: the address of the compiled classes; they work in a worker of their own, as some regions take seconds */
  constructor(engine) {
    Object.assign(this, {engine, regions: new Map()});
    $('stability').ontoggle = () => this.update();
  }

  /** A time step (s) of the scene, chosen or on the way of the slider. */
  show(facts, deltaT) {
    Object.assign(this, {facts, deltaT});
    $('stability').hidden = !(facts.omega > 0);
    this.update();
  }

  update() {
    if (!$('stability').open || $('stability').hidden) {
      return;
    }
    const {solver} = this.facts;
    if (!this.regions.has(solver)) {
      this.regions.set(solver, null);           // it is asked once
      this.ask({type: 'region', solver, ...WINDOW});
    }
    this.z = stiffest(this.facts, this.deltaT);
    this.growth = null;
    this.ask({type: 'region', solver, left: this.z[0], bottom: this.z[1], cell: 0, columns: 1, rows: 1});
    this.tell();
    this.draw();
  }

  /** The window, or its colours, have changed. */
  resize() {
    if (this.z && $('stability').open) {
      this.draw();
    }
  }

  ask(message) {
    if (!this.worker) {
      this.worker = new Worker(this.engine);
      this.worker.onmessage = ({data}) => data.type === 'broken' ? this.fail(data) : this.answer(data);
    }
    this.worker.postMessage(message);
  }

  answer({solver, left, bottom, columns, values}) {
    if (columns > 1) {
      this.regions.set(solver, values);
    } else if (solver === this.facts.solver && left === this.z[0] && bottom === this.z[1]) {
      this.growth = values[0];
    }
    this.tell();
    this.draw();
  }

  /** A student's own solver has thrown something. */
  fail({message, asked}) {
    if (asked.solver === this.facts.solver) {
      this.growth = null;
      $('growth').textContent = TEXTS.untried(asked.solver, message);
    }
  }

  tell() {
    const [re, im] = this.z, growth = this.growth;
    $('growth').textContent = 'h λ = ' + digits(re) + (im > 0 ? ' ± ' + digits(im) + ' i' : '')
        + (growth === null ? '' : growth > 1 + ROUNDING ? TEXTS.grows(factor(growth))
        : growth > 1 - 1e-6 ? TEXTS.keepsSize : TEXTS.decays(factor(growth)));
  }

  draw() {
    const canvas = $('region'), width = canvas.clientWidth;
    const height = Math.round(width * 2 * TOP / (RIGHT - WINDOW.left));
    Object.assign(canvas, {width: width * devicePixelRatio, height: height * devicePixelRatio});
    canvas.style.height = height + 'px';
    const c = canvas.getContext('2d'), values = this.regions.get(this.facts.solver);
    c.scale(devicePixelRatio, devicePixelRatio);
    c.font = '12px system-ui, sans-serif';
    const x = re => (re - WINDOW.left) / (RIGHT - WINDOW.left) * width, y = im => (TOP - im) / (2 * TOP) * height;
    const cell = WINDOW.cell / (RIGHT - WINDOW.left) * width;
    c.fillStyle = ink('--region');
    values?.forEach((growth, k) => {
      const re = WINDOW.left + WINDOW.cell * (k % WINDOW.columns), im = WINDOW.cell * Math.floor(k / WINDOW.columns);
      for (const bottom of growth <= 1 + ROUNDING ? [im, -im - WINDOW.cell] : []) {
        c.fillRect(x(re), y(bottom + WINDOW.cell), cell + 0.5, cell + 0.5);
      }
    });
    c.strokeStyle = ink('--soft');
    c.strokeRect(x(0), -1, 0, height + 2);
    c.strokeRect(-1, y(0), width + 2, 0);
    c.fillStyle = ink('--ink');
    for (let re = WINDOW.left + 1; re < RIGHT; re++) {
      c.fillText(re, x(re) - 3, y(0) + 14);
    }
    for (let im = 1 - TOP; im < TOP; im++) {
      im && c.fillText(im + ' i', x(0) + 4, y(im) + 4);
    }
    c.fillText(values ? TEXTS.coloured : TEXTS.computing, 8, 16);
    for (const sign of [1, -1]) {
      const [re, im] = [this.z[0], sign * this.z[1]];
      const at = [Math.min(width - 8, Math.max(8, x(re))), Math.min(height - 8, Math.max(8, y(im)))];
      c.fillStyle = ink('--wrong');
      c.beginPath();
      c.arc(...at, 5, 0, 2 * Math.PI);
      c.fill();
      re < WINDOW.left || im > TOP || re > RIGHT ? c.fillText(TEXTS.outside, 18, at[1] + 4) : 0;
    }
  }
}

/** h lambda of the root of lambda^2 + c lambda + omega^2 = 0 that is largest: its real part and its imaginary one. */
function stiffest({omega, damping}, h) {
  const square = damping * damping / 4 - omega * omega;
  return square < 0 ? [-h * damping / 2, h * Math.sqrt(-square)] : [-h * (damping / 2 + Math.sqrt(square)), 0];
}

function factor(growth) {
  const difference = growth - 1;
  return Math.abs(difference) < 0.01 ? '1 ' + (difference > 0 ? '+ ' : '- ') + digits(Math.abs(difference))
      : digits(growth);
}
