// Labels of particles and arrows along their velocities, over the picture so that nothing hides them.
const MOST_NAMES = 300, FEW_NAMES = 12;
const HEAD = 11, LONGEST = 1e5;         // pixels

export class Marks {
  constructor(element) {
    this.element = element;
    this.labels = [];
    element.insertAdjacentHTML('beforeend', '<svg class="arrows"><path/><path class="pull"/></svg>');
    [this.arrows, this.pull] = element.lastChild.children;
  }

  /**
   * The labels that the scene gives to particles and, where names are wanted, the names of the first particles. Where
   * many would overlap, the earlier one is shown, and the scene's before all others.
   */
  setLabels(ids, marks, withNames) {
    this.labels.splice(0).forEach(({element}) => element.remove());
    ids.forEach((id, particle) => {
      const texts = [withNames && particle < MOST_NAMES ? id : '', marks[id]?.label ?? ''].filter(text => text);
      if (texts.length) {
        const element = document.createElement('span');
        element.className = 'name';
        element.textContent = texts.join(': ');
        this.element.append(element);
        this.labels.push({particle, element, width: element.offsetWidth, height: element.offsetHeight,
          first: marks[id]?.label ? 0 : 1});
      }
    });
    this.labels.sort((a, b) => a.first - b.first);
  }

  /**
   * place(i, seconds) is where particle i is seen, or will be seen at its present velocity: pixels from the left and
   * from the top, or null behind the camera; away(i) is how many pixels its label keeps from its middle
   */
  draw(place, away, moving, seconds) {
    const taken = [], many = this.labels.length > FEW_NAMES;
    for (const {particle, element, width, height} of this.labels) {
      const at = place(particle, 0), gap = away(particle);
      const left = at && (at[0] + gap + width < this.element.clientWidth ? at[0] + gap : at[0] - gap - width);
      const box = at && [left, at[1] - height / 2, left + width, at[1] + height / 2];
      element.hidden = !box || many && taken.some(other => box[0] < other[2] && other[0] < box[2] && box[1] < other[3]
          && other[1] < box[3]);
      if (!element.hidden) {
        taken.push(box);
        element.style.transform = `translate(${box[0]}px, ${box[1]}px)`;
      }
    }
    this.arrows.setAttribute('d', seconds > 0
        ? moving.map(i => arrow(place(i, 0), place(i, seconds))).join('') : '');
  }

  /** The spring to the pointer, from where the particle is seen to the pointer. */
  drawPull(from, to) {
    this.pull.setAttribute('d', from && to ? `M${from.join(' ')}L${to.join(' ')}` : '');
  }
}

/** A line with a head at its end, as an SVG path. */
export function arrow(from, to) {
  const length = from && to ? Math.hypot(to[0] - from[0], to[1] - from[1]) : 0;
  if (!(length > 1 && length < LONGEST)) {
    return '';
  }
  const ex = (to[0] - from[0]) / length, ey = (to[1] - from[1]) / length, head = Math.min(length, HEAD);
  const side = k => [to[0] - head * ex - 0.45 * k * head * ey, to[1] - head * ey + 0.45 * k * head * ex];
  const points = [from, [to[0] - 0.9 * head * ex, to[1] - 0.9 * head * ey], to, side(1), side(-1)]
      .map(point => point.map(value => value.toFixed(1)).join(' '));
  return `M${points[0]}L${points[1]}M${points[2]}L${points[3]}L${points[4]}Z`;
}
