// What the page shows is in its address, so that a link, a bookmark or the reload button brings it back.
import {make} from './dom.js';
import {pack, save, unpack} from './packing.js';

export const MOST = 8000;               // characters; some mail programs and chats cut longer ones
const TYPED = ['scene', 'solver', 'deltaT', 'set', 'time'];     // what people may read and change in it
const PAUSE = 400;                      // milliseconds without a change, then the address is written

export class Address {
  /** describe() gives the state to be kept, open(state) goes there, tell(text) says something to the person */
  constructor(describe, open, tell) {
    Object.assign(this, {describe, open, tell});
    addEventListener('hashchange', () => this.read());
  }

  /** Opens the state of the address. @returns whether it has one that can be read */
  async read() {
    const {more, ...typed} = Object.fromEntries(new URLSearchParams(location.hash.slice(1).replace(/\+/g, '%2B')));
    return location.hash.length > 1 && this.take(TEXTS.address, async () =>
        ({...(more && JSON.parse(await unpack(more))), ...typed}));
  }

  /** Opens the state that read() gives. @returns whether it does */
  async take(name, read) {
    try {
      this.open(await read());
      return true;
    } catch (error) {
      console.warn(error);
      this.tell(TEXTS.damaged(name));
      return false;
    }
  }

  /** Something has changed. */
  changed() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.write(), PAUSE);
  }

  /** @returns the address of the present state, or null if it is too long; then the page's address has no state */
  async write() {
    clearTimeout(this.timer);
    const url = new URL(location.href);
    const state = this.describe(), words = TYPED.filter(key => state[key]).map(key => key + '='
        + encodeURIComponent(state[key]).replace(/%(5B|5D|3D|2C)/g, decodeURIComponent));
    TYPED.forEach(key => { delete state[key]; });
    url.hash = [...words, 'more=' + await pack(JSON.stringify(state))].join('&');
    const fits = url.href.length <= MOST;
    url.hash = fits ? url.hash : '';
    history.replaceState(history.state, '', url);
    return fits ? url.href : null;
  }

  /** A link that others cannot use, or none, comes with a file in its place. */
  async copy() {
    const link = await this.write(), isLocal = location.protocol === 'file:';
    const done = link === null ? TEXTS.tooLong
        : await navigator.clipboard?.writeText(link).then(() => TEXTS.copied, () => null)
        ?? TEXTS.notCopied;
    const file = make('button', {textContent: TEXTS.saveState, onclick: () => save('lab.json',
        new Blob([JSON.stringify(this.describe())], {type: 'application/json'}))});
    const embed = make('input', {type: 'text', readOnly: true, ariaLabel: TEXTS.toEmbed,
      value: `<iframe src="${link}" width="1000" height="700"></iframe>`});
    this.tell(done, ...(link !== null && !isLocal ? [' ', TEXTS.toEmbed, ' ', embed]
        : [' ', isLocal ? TEXTS.local : '', ' ', TEXTS.sendFile, ' ', file]));
  }
}
