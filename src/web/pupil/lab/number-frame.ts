import { syntaxTree } from '@codemirror/language';
import { StateEffect, StateField, type EditorState, type Extension } from '@codemirror/state';
import { Decoration, EditorView, keymap, showTooltip, ViewPlugin, type Tooltip } from '@codemirror/view';
import { mdiFlaskOutline } from '@mdi/js';

import { isSame } from '#core/same';

import { t } from '../../kit/i18n';
import words from './words';

/** The place where numbers of the program are tried. */
export interface NumberTries {
  /** False where the page offers no experiments with this file. */
  readonly isOffered: () => boolean;
  /** True while the card beside a number is open. */
  readonly isOpen: () => boolean;
  /** Opens the card for the number at this place of the text. */
  readonly open: (at: number) => void;
}

/** The number that was pressed. */
interface Framed {
  readonly from: number;
  readonly to: number;
  readonly isOpen: boolean;
}

const leave = StateEffect.define();
/** The number at the cursor was pressed. */
const tap = StateEffect.define();
/** Its card is open: the button has done its part. */
const open = StateEffect.define();

/**
 * A frame around the number that was pressed, with a button to try others in its place; Alt+Enter does the same at the cursor.
 * Writing takes both away.
 */
export function numberFrame(tries: NumberTries): Extension {
  function openCard(view: EditorView, from: number): void {
    tries.open(from);
    view.dispatch({ effects: open.of(null) });
  }
  const field = StateField.define<Framed | null>({
    create: () => null,
    update(framed, transaction) {
      if (transaction.docChanged || transaction.effects.some((effect) => effect.is(leave))) return null;
      if (transaction.effects.some((effect) => effect.is(open))) return opened(numberAt(transaction.state));
      const isTapped = transaction.effects.some((effect) => effect.is(tap));
      if (transaction.selection === undefined && !isTapped) return framed;
      const found = isTapped && tries.isOffered() ? numberAt(transaction.state) : null;
      return isSame(found, framed) ? framed : found;
    },
    provide: (it) => [
      showTooltip.from(it, (framed) => (framed === null || framed.isOpen ? null : tooltipAt(framed, openCard))),
      EditorView.decorations.from(it, (framed) =>
        framed === null ? Decoration.none : Decoration.set(frame.range(framed.from, framed.to)),
      ),
    ],
  });
  return [
    field,
    keymap.of([
      {
        key: 'Alt-Enter',
        run: (view) => {
          const found = tries.isOffered() ? numberAt(view.state) : null;
          if (found !== null) openCard(view, found.from);
          return found !== null;
        },
      },
    ]),
    // It comes with the first press on the program, which it would miss otherwise.
    ViewPlugin.define((view) => {
      if (view.hasFocus) queueMicrotask(() => view.dispatch({ effects: tap.of(null) }));
      return {};
    }),
    EditorView.domEventHandlers({
      // The selection is set by then, be it the same as before.
      click: (_event, view) => view.dispatch({ effects: tap.of(null) }),
      blur: (_event, view) => {
        queueMicrotask(() => {
          if (view.state.field(field, false) && !tries.isOpen()) view.dispatch({ effects: leave.of(null) });
        });
      },
    }),
    look,
  ];
}

const opened = (framed: Framed | null): Framed | null => framed && { ...framed, isOpen: true };

const frame = Decoration.mark({ class: 'cm-framedNumber' });

/** The number at the cursor; `null`: there is none, or something is selected. */
function numberAt(state: EditorState): Framed | null {
  const { main } = state.selection;
  if (!main.empty) return null;
  for (const side of [1, -1] as const) {
    const node = syntaxTree(state).resolveInner(main.head, side);
    if (node.name === 'Number') return { from: node.from, to: node.to, isOpen: false };
  }
  return null;
}

function tooltipAt({ from, to }: Framed, openCard: (view: EditorView, from: number) => void): Tooltip {
  return {
    pos: to,
    above: false,
    create: (view) => {
      const dom = document.createElement('div');
      dom.className = 'cm-tryNumber';
      const button = document.createElement('button');
      button.type = 'button';
      button.dataset['testid'] = 'try-number';
      button.title = 'Alt+Enter';
      const icon = `<svg viewBox="0 0 24 24" width="20" height="20" aria-hidden="true"><path fill="currentColor" d="${mdiFlaskOutline}"/></svg>`;
      button.innerHTML = icon;
      button.append(t(words.try));
      // The keyboard of a phone stays where it is.
      button.addEventListener('mousedown', (event) => event.preventDefault());
      button.addEventListener('click', () => openCard(view, from));
      dom.append(button);
      return { dom, offset: { x: 6, y: 3 } };
    },
  };
}

const look = EditorView.theme({
  '.cm-framedNumber': {
    borderRadius: '4px',
    outline: '2px solid var(--accent-line)',
    outlineOffset: '1px',
    fontWeight: '700',
  },
  '.cm-tooltip.cm-tryNumber': { borderRadius: 'var(--r-m)' },
  '.cm-tryNumber button': {
    display: 'flex',
    alignItems: 'center',
    gap: '6px',
    minHeight: '36px',
    padding: '0 12px 0 8px',
    border: '0',
    borderRadius: 'var(--r-m)',
    background: 'none',
    color: 'var(--text)',
    font: '500 14px/1 var(--sans)',
    cursor: 'pointer',
  },
  '@media (pointer: coarse)': { '.cm-tryNumber button': { minHeight: '44px' } },
});
