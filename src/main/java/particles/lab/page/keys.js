// Keys that work anywhere on the page, except where they are typed into a field or mean something to a control.
const FIELDS = 'input:not([type=checkbox], [type=range]), select, textarea, .CodeMirror, dialog';
const TAKERS = {' ': 'button, input, summary, a', ArrowLeft: 'input', ArrowRight: 'input'};

/** actions: what is done, by key, with ^ for Ctrl or ⌘; one that returns false leaves the key to the browser */
export function listen(actions) {
  addEventListener('keydown', event => {
    const key = (event.ctrlKey || event.metaKey ? '^' : '')
        + (event.key.length === 1 ? event.key.toLowerCase() : event.key);
    if (!actions[key] || event.defaultPrevented || event.altKey
        || event.target.closest?.(FIELDS) || TAKERS[key] && event.target.closest?.(TAKERS[key])) {
      return;
    }
    if (actions[key](event) !== false) {
      event.preventDefault();
    }
  });
}
