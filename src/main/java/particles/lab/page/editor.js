// The scene's text, with our own error lines at their places.
import {$, make} from './dom.js';
import {save} from './packing.js';

export class Editor {
  /** changed() is called when somebody has typed and paused. */
  constructor(textarea, changed) {
    this.changed = changed;
    this.code = CodeMirror.fromTextArea(textarea, {mode: 'yaml', theme: 'page', lineNumbers: true, tabSize: 2,
      screenReaderLabel: TEXTS.elements.editorName, extraKeys: {Tab: false, 'Shift-Tab': false}});
    this.code.getScrollerElement().tabIndex = 0;         // for keys that scroll
    this.marks = [];
    this.code.on('change', (code, change) => {
      if (change.origin !== 'setValue') {
        clearTimeout(this.timer);
        this.timer = setTimeout(() => this.settle(), 400);
      }
    });
  }

  get text() {
    return this.code.getValue();
  }

  set text(text) {
    clearTimeout(this.timer);
    this.timer = null;
    this.code.setValue(text);
    this.code.clearHistory();
  }

  /** Takes what has been typed so far, without waiting for the pause. */
  settle() {
    if (this.timer) {
      clearTimeout(this.timer);
      this.timer = null;
      this.changed();
    }
  }

  /** A mark on a part of the text, which stays on it while the text changes. */
  mark({from, to}) {
    return this.code.markText(from, to, {inclusiveLeft: true, inclusiveRight: true, clearWhenEmpty: false});
  }

  /** Draws the text once, after all that some work does to it. */
  atOnce(work) {
    this.code.operation(work);
  }

  /** Writes a text in place of what is marked, as if it had been typed. */
  write(marks, text) {
    this.atOnce(() => marks.forEach(mark => {
      const {from, to} = mark.find() ?? {};
      if (from) {
        this.code.replaceRange(text, from, to, '+input');
      }
    }));
  }

  /** Another text in place of all, as one change; undo() takes the last change back, undo(true) makes it again. */
  replace(text) {
    this.code.replaceRange(text, {line: 0, ch: 0}, {line: this.code.lineCount(), ch: 0}, 'build');
    this.settle();
  }

  undo(redo) {
    redo ? this.code.redo() : this.code.undo();
    this.settle();
  }

  /** From now on the text can only be read. */
  lock() {
    this.code.setOption('readOnly', true);
  }

  /** Needed after it was hidden. */
  refresh() {
    this.code.refresh();
  }

  save(name) {
    save(name, new Blob([this.text], {type: 'text/yaml'}));
  }

  /** Each line is 'file:line:column: what is wrong', or without a place. */
  show(errors) {
    this.marks.splice(0).forEach(mark => mark.clear());
    this.code.eachLine(line => this.code.removeLineClass(line, 'background', 'wrong-line'));
    $('errors').replaceChildren(...errors.map(error => {
      const place = /^[^:]*:(\d+)(?::(\d+))?: /.exec(error);
      const button = make('button', {textContent: error});
      if (place) {
        const line = place[1] - 1, column = (place[2] ?? 1) - 1;
        this.code.addLineClass(line, 'background', 'wrong-line');
        this.marks.push(this.code.markText({line, ch: column}, {line, ch: this.code.getLine(line)?.length ?? column},
            {className: 'wrong-place'}));
        button.onclick = () => { this.code.setCursor({line, ch: column}); this.code.focus(); };
      }
      return make('li', {}, button);
    }));
  }
}
