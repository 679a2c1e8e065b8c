// The equations of the forces that a scene names, typeset, with their numbers; and the solver's formula.
import {$, few, make} from './dom.js';

const FORMULAS = JSON.parse($('formulas')?.textContent ?? '{}');        // by name; none of a recorded run
const SIGNS = {'.': '\u22c5', '-': '\u2212', '~': '\u2212', "'": '\u2032', '<': '&lt;', pi: '\u03c0', mu: '\u03bc',
  lambda: '\u03bb'};
const MORE = {'|': ' lspace="0" rspace="0"', '~': ' form="prefix"'};
const WORDS = /[A-Za-z]{2,}(?: [A-Za-z]{2,})+/, ATOM = /([A-Za-z]+|\d[\d.]*|[^\s\w])(?:_(\w+))?(?:\^(\w+|\([^)]*\)))?/;
const TOKEN = RegExp('(?<=\\w) (?=\\w)|' + WORDS.source + '|' + ATOM.source, 'g');
const tag = (name, content, more = '') => `<${name}${more}>${content}</${name}>`;
const atom = text => /^\w/.test(text) ? tag(/^\d/.test(text) ? 'mn' : 'mi', SIGNS[text] ?? text)
    : tag('mo', SIGNS[text] ?? text, ' stretchy="false"' + (MORE[text] ?? ''));

/** A part of a line of text as MathML: a_b is an index, a^b a power, and a space between two names keeps them apart. */
const typeset = part => tag('math', part.replace(/([=(] ?)-/g, '$1~').replace(TOKEN, (all, base, sub, sup) =>
    all === ' ' ? tag('mspace', '', ' width=".2em"') + ' ' : base === undefined ? tag('mtext', all)
    : tag('m' + (sub ? 'sub' : '') + (sup ? 'sup' : '') + (sub || sup ? '' : 'row'),
        atom(base) + [sub, sup].filter(one => one).map(one => tag('mtext', one)).join(''))));

const shown = value => Array.isArray(value) ? '(' + value.map(one => few(one)).join(', ') + ')' : few(value);

/** The smallest and the largest number, if they differ. */
const span = numbers => TEXTS.span([...new Set([Math.min(...numbers), Math.max(...numbers)])].map(one => few(one)));

/** solver: its name; laws: those that the scene names; structure: the particles and springs */
export function showEquations({solver, laws, dampings}, {stiffness, restLengths}) {
  const springs = [...stiffness.keys()].filter(s => stiffness[s] < Infinity);
  const of = column => springs.map(s => column[s]);
  const all = new Map(springs.length ? [['springs', [['k = ' + span(of(stiffness)) + ' N/m',
    'l = ' + span(of(restLengths)) + ' m', 'k_d = ' + span(dampings) + ' N s/m']]]] : []);
  laws.forEach(({name, numbers}) => all.set(name, [...all.get(name) ?? [], numbers.map(([key, value, unit]) =>
    `${key} = ${shown(value)} ${unit.replace('^2', '²')}`.trim())]));
  $('equations').replaceChildren(...[...all].filter(([name]) => FORMULAS[name]).flatMap(([name, each]) => [
    make('h2', {textContent: name}),
    ...FORMULAS[name].split('\n').filter(line => !/^\w+:/.test(line) || line.startsWith(name + ':'))
        .map(line => make('p', {innerHTML: line.trim().split(/ {2,}/).map(typeset).join(' &emsp;')})),
    ...each.map(lines => make('p', {className: 'soft', textContent: lines.join(', ')}))]),
    ...(FORMULAS[solver] ? [make('h2', {textContent: solver}), make('pre', {textContent: FORMULAS[solver]})] : []));
}
