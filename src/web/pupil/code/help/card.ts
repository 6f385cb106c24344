import { parametersOf } from '#reference/arguments';
import type { Item } from '#reference/item';
import { resultOf } from '#reference/meaning';
import { captionOf, missingText, wordsOn, type Words } from './words-on';

/** Makes an element with a class and its contents. */
export function element(tag: string, className: string, ...inside: (Node | string)[]): HTMLElement {
  const made = document.createElement(tag);
  made.className = className;
  made.append(...inside);
  return made;
}

/** How a name is called, `show(image, delay=400)`, with one parameter marked; −1 marks none. */
export function signature(label: string, call: string, marked = -1): HTMLElement {
  const line = element('div', 'cm-helpCall', element('b', 'cm-helpName', label), '(');
  let byName = false;
  for (const [place, parameter] of parametersOf(call).entries()) {
    if (place > 0) line.append(', ');
    if (parameter.byName && !byName && !parameter.rest) line.append('*, ');
    byName = byName || parameter.byName || parameter.rest;
    line.append(element(place === marked ? 'mark' : 'span', 'cm-helpParameter', ...parameterParts(parameter.text)));
  }
  const result = resultOf(call);
  line.append(')');
  if (result !== '' && result !== 'None') line.append(element('span', 'cm-helpType', ` → ${result}`));
  return line;
}

/** The short form: types and `*` left out, except for the parameter that is being written. */
export function shortSignature(label: string, call: string, marked: number): HTMLElement {
  const line = element('div', 'cm-helpCall', element('b', 'cm-helpName', label), '(');
  for (const [place, { text }] of parametersOf(call).entries()) {
    if (place > 0) line.append(', ');
    const short = text.replace(/: [^=]+?(?= =|$)/, '').replace(' = ', '=');
    const isMarked = place === marked;
    line.append(
      element(isMarked ? 'mark' : 'span', 'cm-helpParameter', ...(isMarked ? parameterParts(text) : [short])),
    );
  }
  line.append(')');
  return line;
}

/** `delay: int = 400` as name, type and default. */
function parameterParts(text: string): Node[] {
  const [, name = text, type, given] = /^(\**\w+)(?:: ([^=]+?))?(?: ?= ?(.*))?$/.exec(text) ?? [];
  const parts: Node[] = [new Text(name)];
  if (type !== undefined) parts.push(element('span', 'cm-helpType', `: ${type}`));
  if (given !== undefined) parts.push(new Text(type === undefined ? `=${given}` : ` = ${given}`));
  return parts;
}

/** The card on an item: how it is called, what it does, where it belongs. */
export function card(item: Item, words: Words, argument: string | null = null): HTMLElement {
  const made = element('div', 'cm-helpCard');
  for (const call of item.calls) {
    const marked = argument === null ? -1 : parametersOf(call).findIndex(({ name }) => name === argument);
    made.append(signature(item.label, call, marked));
  }
  if (item.calls.length === 0) {
    const type = item.type === null ? '' : `: ${item.type}`;
    made.append(element('div', 'cm-helpCall', element('b', 'cm-helpName', item.label), type));
  }
  const text = wordsOn(item, words);
  if (text !== '') made.append(element('p', 'cm-helpText', text));
  const missing = missingText(item);
  if (missing !== '') made.append(element('p', 'cm-helpMissing', missing));
  made.append(element('div', 'cm-helpCaption', captionOf(item)));
  return made;
}

/** The card as one sentence, for screen readers. */
export function spoken(item: Item, words: Words): string {
  const parameters = parametersOf(item.calls[0] ?? '').map(({ name }) => name);
  const call = item.calls.length === 0 ? item.label : `${item.label}(${parameters.join(', ')})`;
  return [call, wordsOn(item, words), missingText(item)].filter((part) => part !== '').join('. ');
}
