// Up to three more runs beside the first, each with its own solver, deltaT and, where somebody has edited it, its own
// text of the scene; they follow the time of the first.
import {$, few, make} from './dom.js';
import {SOLVERS} from './opening.js';
import {columnsOf} from './structure.js';
import {makeView} from './view.js';

const MOST = 3;
export const COLOURS = ['#e69f00', '#009e73', '#cc79a7'];       // the first run is blue

export const captionOf = ({solver, deltaT}) => TEXTS.caption(solver, few(deltaT));
export const momentOf = ({time, evaluations}) => TEXTS.moment(few(time), evaluations);

const line = (text, key) => RegExp('^' + key + ':.*', 'm').exec(text)?.[0];
/** Whether the line of a key differs in two texts. */
export const differs = (key, one, other) => line(one, key) !== line(other, key);

export class Panels {
  /**
   * engine: the address of the compiled classes; changed(): one came, went, or is to run something else;
   * heard(i, message): what one tells
   */
  constructor(engine, changed, heard) {
    Object.assign(this, {engine, changed, heard, all: []});
    $('addPanel').onclick = () => this.set([...this.describe(), {}]);
    $('equalWork').onchange = () => this.set(this.describe());
  }

  describe() {
    return this.all.map(panel => panel.choice);
  }

  /** The first run has another scene: own texts of the one before are no longer needed. */
  forgetTexts() {
    this.all.forEach(panel => { delete panel.choice.text; });
  }

  /** Replaces all runs by those with these choices, {solver, deltaT, text}. */
  set(choices) {
    this.all.forEach(panel => panel.close());
    this.all = choices.slice(0, MOST).map((choice, i) => new Panel(this, i, choice));
    $('addPanel').disabled = this.all.length === MOST;
    $('equalWork').hidden = !this.all.length;
    this.changed();
  }

  remove(panel) {
    this.set(this.all.filter(one => one !== panel).map(one => one.choice));
  }

  /** Opens the scene of the first run; facts are what is known of that run. */
  open(sent, facts) {
    this.all.forEach(panel => panel.open(sent, facts));
  }

  tell(message) {
    this.all.forEach(panel => panel.worker.postMessage(message));
  }

  /** The time step that costs as many evaluations per simulated second as the first run; NaN if that is not known. */
  equalStep(solver, facts) {
    const cost = name => Number(SOLVERS.find(one => one.name === name)?.evaluations);
    return Number((facts.deltaT * cost(solver) / cost(facts.solver)).toPrecision(6));
  }

  draw(camera, arrows) {
    this.all.forEach(panel => panel.draw(camera, arrows));
  }

  resize() {
    this.all.forEach(panel => panel.view.resize());
  }
}

class Panel {
  constructor(panels, index, choice) {
    Object.assign(this, {panels, index, choice: {solver: 'euler', deltaT: '', ...choice}});
    this.caption = make('figcaption', {className: 'caption'});
    const picture = make('div', {className: 'view', role: 'img', ariaLabel: TEXTS.sceneOf(this.name)});
    this.figure = make('figure', {}, picture, this.caption);
    $('views').append(this.figure);
    this.view = makeView(picture);
    this.addControls();
    this.worker = new Worker(panels.engine);
    this.worker.onmessage = ({data}) => this.hear(data);
  }

  addControls() {
    this.solver = make('select', {onchange: () => this.choose({solver: this.solver.value})},
        ...SOLVERS.map(one => new Option(one.name)));
    this.solver.value = this.choice.solver;
    this.step = make('input', {type: 'text', inputMode: 'decimal', disabled: Boolean($('equalWork').value),
      onchange: () => this.choose({deltaT: this.step.value.trim()})});
    this.error = make('p', {role: 'alert'});
    this.row = make('li', {}, make('label', {}, TEXTS.solverOf(this.name) + ' ', this.solver),
        make('label', {}, TEXTS.itsStep + ' ', this.step),
        make('button', {textContent: TEXTS.remove, onclick: () => this.panels.remove(this)}), this.error);
    this.row.style.borderColor = this.caption.style.borderColor = COLOURS[this.index];
    $('panelList').append(this.row);
  }

  get name() {
    return TEXTS.run(this.index + 2);
  }

  choose(more) {
    Object.assign(this.choice, more);
    this.panels.changed();
  }

  /** Its own text of the scene; the first run's is not its own. What a text says of solver and deltaT then goes. */
  edit(text, first) {
    const before = this.choice.text ?? first;
    this.choose({text: text === first ? undefined : text, ...(differs('solver', before, text) && {solver: ''}),
      ...(differs('deltaT', before, text) && {deltaT: ''})});
  }

  open(sent, facts) {
    const {solver, deltaT, text} = this.choice;
    const opening = this.opening = {type: 'open', ...sent, endless: true, text: text ?? sent.text, solver, tolerance: 0,
      deltaT: String(deltaT || (text === undefined ? facts.deltaT : ''))};
    this.facts = null;
    this.note = '';
    this.equalise = $('equalWork').value ? own => this.openEqually(opening, this.panels.equalStep(own, facts)) : null;
    this.worker.postMessage(opening);
  }

  /** Once it is known which solver the text or the choice names. */
  openEqually(opening, deltaT) {
    if (deltaT > 0) {
      this.opening = {...opening, deltaT: String(deltaT)};
      this.worker.postMessage(this.opening);
    } else {
      this.note = TEXTS.noCost;
    }
    return deltaT > 0;
  }

  hear(message) {
    if (message.type === 'opened') {
      const {errors, solver} = message.facts, equalise = this.equalise;
      this.equalise = null;
      if (!errors && equalise?.(solver)) {
        return;                         // it is opened once more
      }
      this.error.textContent = errors ? errors.join('\n').replace(/^deltaT: /gm, '') : this.note;
      this.facts = errors ? this.facts : message.facts;
      this.opened = false;
      this.step.value = message.facts.deltaT ?? this.step.value;
      this.solver.value = message.facts.solver ?? this.choice.solver;
    } else if (message.type === 'frame' && this.facts) {
      this.show(message);
    } else if (message.type === 'broken') {
      this.error.textContent = message.message;
    }
    this.panels.heard(this.index, message);
  }

  show(message) {
    if (message.structure) {
      this.structure = columnsOf(message.structure);
      if (!this.opened) {
        this.view.open(this.facts, this.structure, message.state);
        this.opened = true;
      }
      this.view.setStructure(this.structure);
    }
    this.view.show(message);
    this.error.textContent = message.failure || this.note;
    this.caption.textContent = captionOf(this.facts) + momentOf(message)
        + (this.choice.text === undefined ? '' : TEXTS.ownText);
  }

  /** Looks at the scene from where the first picture does. */
  draw(camera, arrows) {
    if (this.opened && camera) {
      const pose = camera.pose();
      if (pose.join() !== this.pose) {
        this.pose = pose.join();
        this.view.camera.restore(pose);
      }
      if (this.view.showArrows !== arrows) {
        this.view.setArrows(arrows);
      }
    }
    this.view.draw();
  }

  close() {
    this.worker.terminate();
    this.view.close();
    this.figure.remove();
    this.row.remove();
  }
}
