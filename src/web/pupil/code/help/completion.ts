import {
  acceptCompletion,
  autocompletion,
  closeCompletion,
  completionStatus,
  moveCompletionSelection,
  selectedCompletion,
  startCompletion,
  type Completion,
  type CompletionContext,
  type CompletionResult,
} from '@codemirror/autocomplete';
import { EditorState, Prec, type Extension } from '@codemirror/state';
import { EditorView, keymap, type Command, type Rect } from '@codemirror/view';

import { parametersOf } from '#reference/arguments';
import { complete, type Offer } from '#reference/complete';
import type { ReferenceContext } from '#reference/context';
import type { Item } from '#reference/item';
import { t } from '../../../kit/i18n';
import { card, element } from './card';
import { insertCall } from './given-brackets';
import helpWords from './words';
import type { Words } from './words-on';

/** One sign for each kind of name, before its label. */
const SIGNS: Readonly<Record<Item['kind'], string>> = {
  function: 'ƒ',
  type: 'C',
  exception: '!',
  value: '#',
  object: 'o',
  module: 'M',
  keyword: '·',
  variable: 'x',
  parameter: '=',
};

/** Suggestions while typing: Enter, Tab or a tap takes one, Escape closes, Ctrl+Space asks for them. */
export function completion(context: () => ReferenceContext, words: Words): Extension {
  /**
   * The place where the pupil requested suggestions: it offers everything, other places only what fits a begun word.
   */
  let askedAt = -1;
  const ask: Command = (view) => {
    askedAt = view.state.selection.main.head;
    return startCompletion(view);
  };
  return [
    autocompletion({
      override: [(at) => suggest(at, at.explicit && at.pos === askedAt, context(), words)],
      icons: false,
      defaultKeymap: false,
      maxRenderedOptions: 60,
      activateOnTypingDelay: 60,
      positionInfo: placeCard,
      optionClass: (it) => `cm-helpOption cm-helpOption-${it.type ?? ''}`,
      addToOptions: [{ position: 20, render: sign }],
      // The order of the tables: what lessons use first stands first.
      compareCompletions: (a, b) => ((a.sortText ?? '') < (b.sortText ?? '') ? -1 : 1),
    }),
    EditorState.phrases.of({ Completions: t(helpWords.suggestions) }),
    Prec.highest(
      keymap.of([{ key: 'Ctrl-Space', run: ask }, { mac: 'Alt-`', run: ask }, { mac: 'Alt-i', run: ask }, ...keys]),
    ),
    EditorView.domEventHandlers({ blur: (_event, view) => dropPending(view) }),
  ];
}

/** A late list must not open over the page after the pupil has gone to Run: the library closes only open lists. */
function dropPending(view: EditorView): void {
  if (completionStatus(view.state) === 'pending') setTimeout(() => closeCompletion(view));
}

function suggest(
  at: CompletionContext,
  isAsked: boolean,
  context: ReferenceContext,
  words: Words,
): CompletionResult | null {
  const source = at.state.doc.toString();
  const found = complete(source, at.pos, context);
  if (found === null) return null;
  const { from, items } = found;
  const typed = source.slice(from, at.pos);
  const before = source.slice(0, from);
  if (!isAsked && typed === '' && !/(\.|\bimport |\bfrom |['"])$/.test(before)) return null;
  // There is nothing to suggest once the only fitting name is written.
  const fitting = items.filter(({ item }) => item.label.startsWith(typed));
  if (!isAsked && fitting.length === 1 && fitting[0]?.item.label === typed) return null;
  const inImport = /^[ \t]*(import|from)\b[^\n]*$/m.test(before.slice(before.lastIndexOf('\n') + 1));
  return { from, options: items.map((offer, place) => optionOf(offer, place, inImport, words)) };
}

function optionOf({ item, weight }: Offer, place: number, inImport: boolean, words: Words): Completion {
  const option: Completion = {
    label: item.label,
    type: item.kind,
    detail: detailOf(item),
    boost: weight,
    sortText: String(place).padStart(4, '0'),
    info: () => card(item, words),
  };
  return inImport || !isCalled(item) ? option : { ...option, apply: callOf(item) };
}

/** Widest card, and the gap between list, card and the screen's edge, in px. */
const CARD_PX = 360;
const GAP_PX = 4;

/**
 * The card stands beside the list, on the side with more room; below (or above) it on narrow screens, never over it.
 */
function placeCard(_view: EditorView, list: Rect, option: Rect, info: Rect, space: Rect): { style: string } {
  const width = Math.min(info.right - info.left, CARD_PX);
  const right = space.right - list.right - 2 * GAP_PX;
  const left = list.left - space.left - 2 * GAP_PX;
  if (Math.max(left, right) >= width) {
    const height = info.bottom - info.top;
    const top = Math.max(space.top, Math.min(option.top, space.bottom - height)) - list.top;
    return { style: `top: ${top}px; ${right >= width ? 'left' : 'right'}: 100%; max-width: ${CARD_PX}px` };
  }
  const wide = Math.min(space.right - space.left - 2 * GAP_PX, CARD_PX);
  const shift = Math.min(0, space.right - GAP_PX - wide - list.left);
  const below = space.bottom - list.bottom >= list.top - space.top;
  return {
    style: `${below ? 'top' : 'bottom'}: calc(100% + ${GAP_PX}px); left: ${shift}px; width: ${wide}px; margin: 0`,
  };
}

/** The text after the label in the list: the names of the parameters, or the type. */
function detailOf(item: Item): string {
  if (item.calls.length === 0) return item.type ?? '';
  const names = parametersOf(item.calls[0] ?? '').map(({ name, rest }) => (rest ? `*${name}` : name));
  const text = `(${names.join(', ')})`;
  return text.length <= 30 ? text : `(${names.slice(0, 2).join(', ')}, …)`;
}

/** True if a name is written to be called. Types with constants (`Image.HEART`) are more often written for those. */
function isCalled(item: Item): boolean {
  if (item.calls.length === 0 || item.kind === 'exception') return false;
  return item.text !== 'microbit.Image' && item.text !== 'audio.SoundEffect';
}

const callOf =
  (item: Item) =>
  (view: EditorView, _option: Completion, from: number, to: number): void =>
    insertCall(
      view,
      item.label,
      from,
      to,
      item.calls.some((call) => parametersOf(call).length > 0),
    );

function sign(option: Completion): Node {
  const made = element('span', 'cm-helpSign', SIGNS[(option.type ?? 'value') as Item['kind']]);
  made.setAttribute('aria-hidden', 'true');
  return made;
}

/** Enter ends the line if the word is already complete. */
const acceptOrEndLine: Command = (view) => {
  const chosen = selectedCompletion(view.state);
  const { head } = view.state.selection.main;
  const before = view.state.sliceDoc(Math.max(0, head - (chosen?.label.length ?? 0)), head);
  if (chosen !== null && before === chosen.label && chosen.apply === undefined) {
    closeCompletion(view);
    return false;
  }
  return acceptCompletion(view);
};

/** Escape belongs to the list only while it shows: before, it closes what else is open. */
const closeShown: Command = (view) => {
  const shows = completionStatus(view.state) === 'active';
  closeCompletion(view);
  return shows;
};

/** Asks for suggestions for what was typed before there were any: a name begun, or the dot before one. */
export function suggestLate(view: EditorView): void {
  const { head } = view.state.selection.main;
  if (/[\p{L}_.]$/u.test(view.state.sliceDoc(Math.max(0, head - 1), head))) startCompletion(view);
}

const keys = [
  { key: 'Escape', run: closeShown },
  { key: 'ArrowDown', run: moveCompletionSelection(true) },
  { key: 'ArrowUp', run: moveCompletionSelection(false) },
  { key: 'PageDown', run: moveCompletionSelection(true, 'page') },
  { key: 'PageUp', run: moveCompletionSelection(false, 'page') },
  { key: 'Enter', run: acceptOrEndLine },
  { key: 'Tab', run: acceptCompletion },
];
