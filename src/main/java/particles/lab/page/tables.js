// The numbers behind a plot, for those who do not see it.
import {few, make} from './dom.js';

const MOST_ROWS = 25, INTERVAL = 1000;  // milliseconds between two tables while a run goes on

export class Table {
  /** details: the element that opens; read(): gives the heads and the columns of numbers */
  constructor(details, read) {
    Object.assign(this, {details, read, written: -Infinity});
    details.ontoggle = () => this.draw(Infinity);
  }

  /** Writes rows from the first to the last, as evenly spread as they come. */
  draw(now) {
    if (!this.details.open || now - this.written < INTERVAL) {
      return;
    }
    this.written = now === Infinity ? -Infinity : now;
    const [heads, columns] = this.read(), count = columns[0].length, rows = Math.min(count, MOST_ROWS);
    const table = make('table');
    table.createTHead().append(row('th', heads));
    table.createTBody().append(...Array.from({length: rows}, (none, r) => {
      const k = rows > 1 ? Math.round(r * (count - 1) / (rows - 1)) : 0;
      return row('td', columns.map(column => few(column[k] ?? 0)));
    }));
    this.details.querySelector('div').replaceChildren(table);
  }
}

function row(tag, cells) {
  const all = make('tr');
  all.append(...cells.map(textContent => make(tag, {textContent, ...(tag === 'th' && {scope: 'col'})})));
  return all;
}
