// Sliders for the numbers of the scene's text that say how things behave: stiffness, damping, mass, gravity, wind ...
import {$, few, make} from './dom.js';

const MOST = 20, STEPS = 200, FACTOR = 20, HUGE = 1e29;
const NOT_BEHAVIOUR = /^(camera|look|output|solver|deltaT|duration|blowUpFactor|constraints)$/;
const GRAVITY = /^(\s*-\s*)(gravity(?:: *\{acceleration: *\[0(?:\.0)?, *([-+.\de]+), *0(?:\.0)?\]\})?)(?=\s*(#|$))/;
const digits = value => few(value, 3);

export class Parameters {
  /** editor: holds the text */
  constructor(editor) {
    this.editor = editor;
    this.sliders = [];
  }

  /** The text belongs to another scene: its numbers decide how far the sliders reach. */
  forget() {
    this.ranges = {};
  }

  /** numbers: those that the text holds, each with its key, place, range and unit */
  show(numbers) {
    this.editor.atOnce(() => this.replace(numbers));
  }

  replace(numbers) {
    this.sliders.forEach(({places}) => places.forEach(place => place.clear()));
    const found = parametersOf(numbers, this.editor.text.split('\n')).slice(0, MOST);
    const same = found.map(one => one.label).join() === this.sliders.map(one => one.label).join();
    found.forEach(one => {
      this.ranges[one.label] ??= rangeOf(one);
      Object.assign(one, {range: this.ranges[one.label], places: one.spans.map(span => this.editor.mark(span))});
    });
    if (same) {                         // somebody may have one of them in hand
      this.sliders.forEach((slider, i) => Object.assign(slider, found[i]));
    } else {
      this.sliders = found;
      $('parameters').replaceChildren(...found.flatMap(slider => this.row(slider)));
    }
    this.sliders.forEach(slider => slider.tell());
    $('parameterSection').hidden = !found.length;
  }

  row(slider) {
    const input = make('input', {type: 'range', min: 0, max: STEPS, step: 1}), output = make('output');
    slider.tell = () => {
      const {range, unit, value} = slider, text = digits(value) + ' ' + unit;
      slider.place && (slider.place.value = Object.values(TEXTS.places).includes(value) ? value : '');
      input.value = STEPS * range.part(slider.value);
      input.setAttribute('aria-valuetext', text);
      output.textContent = text;
    };
    input.oninput = () => slider.take(Number(digits(slider.range.value(input.value / STEPS))));
    slider.take = value => {
      slider.value = value;
      output.textContent = digits(value) + ' ' + slider.unit;
      this.editor.write(slider.places, (slider.write ?? String)(value));
    };
    // a label names the first control in it
    return [make('label', {}, slider.label, input, output), ...slider.write ? [this.places(slider)] : []];
  }

  /** The gravity of well-known places. */
  places(slider) {
    slider.place = make('select', {ariaLabel: TEXTS.gravityOf,
      onchange: ({target: {value}}) => slider.take(Number(value))},
        ...Object.entries(TEXTS.places).map(([name, value]) => new Option(name, value)));
    slider.place.options[0].disabled = true;
    return slider.place;
  }
}

/** Numbers with the same key, owner and value are one parameter: all masses of a bag of equal balls. */
function parametersOf(numbers, lines) {
  const isSet = numbers.some(({line, key}) => line < 1 && / of 'acceleration'/.test(key));        // beside the text
  const byPlace = new Map(numbers.filter(({line}) => line > 0)
      .map(number => [number.line + ':' + number.column, number]));
  const groups = new Map(), gravity = [];
  lines.forEach((text, i) => {
    const [all, before, written, value] = GRAVITY.exec(text) ?? [];
    if (all && !isSet) {
      gravity.push(i + 1);
      groups.set('gravity', {label: 'gravity', value: value === undefined ? 9.81 : -value, unit: 'm/s²', least: -25,
        most: 25, spans: [span(i + 1, before.length, written.length)],
        write: g => `gravity: {acceleration: [0, ${g ? -g : 0}, 0]}`});
    }
  });
  for (const number of byPlace.values()) {
    const {section, id, owner} = ownerOf(lines, number), key = number.key.replace(/'/g, '');
    const vector = / of /.test(key);
    if (gravity.includes(number.line) || NOT_BEHAVIOUR.test(section)
        || number.unit === 'm' && key !== 'wavelength' || vector && (number.value === 0 || number.unit === '')) {
      continue;
    }
    const group = [key, section, owner, number.value, number.unit].join();
    const one = groups.get(group) ?? {...number, unit: number.unit.replace('^2', '²').replace('^3', '³'), key,
      owner: id ?? owner, all: owner, spans: []};
    one.spans.push(span(number.line, number.column - 1,
        /^[-+.\w]+/.exec(lines[number.line - 1].slice(number.column - 1))?.[0].length ?? 0));
    one.label = one.key + ' (' + (one.spans.length > 1 ? TEXTS.several(one.all, one.spans.length) : one.owner) + ')';
    groups.set(group, one);
  }
  return named([...groups.values()]);
}

const span = (line, column, length) => ({from: {line: line - 1, ch: column},
  to: {line: line - 1, ch: column + length}});

/** Equal labels get numbers. */
function named(parameters) {
  const seen = {};
  return parameters.map(one => {
    seen[one.label] = (seen[one.label] ?? 0) + 1;
    return {...one, label: one.label + (seen[one.label] > 1 ? ' ' + seen[one.label] : '')};
  });
}

/** The top-level key above a number, the id of its item, and the nearest key that it belongs to. */
function ownerOf(lines, {line, column}) {
  const before = lines[line - 1].slice(0, column - 1), brace = openBrace(before);
  let indent = before.search(/\S/), id = null, owner = null;
  if (brace >= 0) {
    id = /\bid: *"?([^",}]+)/.exec(lines[line - 1].slice(brace))?.[1] ?? null;
    owner = /([\w.]+): *$/.exec(before.slice(0, brace))?.[1] ?? null;
  }
  let section = null;
  for (let i = line - 2; i >= 0 && section === null; i--) {
    const [all, spaces, dash, key, value] = /^(\s*)(- +)?([\w.]+):\s*([^#]*)/.exec(lines[i]) ?? [];
    if (all !== undefined && spaces.length < indent) {
      indent = spaces.length;
      id ??= dash && key === 'id' && brace < 0 ? value.trim() : null;
      owner ??= value.trim() ? null : key;
      section = indent === 0 ? key : null;
    }
  }
  return {section: section ?? /^\w*/.exec(before)[0], id, owner: owner ?? section ?? ''};
}

/** Where the innermost { is that is still open; -1 without one. */
function openBrace(text) {
  const open = [];
  [...text].forEach((letter, i) => letter === '{' ? open.push(i) : letter === '}' && open.pop());
  return open.at(-1) ?? -1;
}

/** From a twentieth to twenty times a positive number, by equal factors; other numbers by equal differences. */
function rangeOf({value, least, most}) {
  if (value > 0 && least >= 0 && most > HUGE) {
    return {value: part => value * FACTOR ** (2 * part - 1),
      part: v => (1 + Math.log(v / value) / Math.log(FACTOR)) / 2};
  }
  const size = 2 * Math.abs(value) || 1, low = Math.max(least, -size), high = Math.min(most, size);
  const [from, to] = Math.abs(least) < HUGE && most < HUGE ? [least, most] : [low, high];
  return {value: part => from + part * (to - from), part: v => (v - from) / (to - from)};
}
