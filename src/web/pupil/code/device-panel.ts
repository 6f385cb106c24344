import { forEachDiagnostic, setDiagnosticsEffect, type Action, type Diagnostic } from '@codemirror/lint';
import { RangeSet, StateField, type EditorState, type Extension } from '@codemirror/state';
import { EditorView, GutterMarker, keymap, showPanel, type Command, type Panel } from '@codemirror/view';
import { mdiAlertOutline, mdiInformationOutline } from '@mdi/js';

import { t } from '../../kit/i18n';
import { deviceGutter } from './device-gutter';
import words from './words';

/** A place that was marked, where it is now. */
interface Marked {
  readonly from: number;
  readonly to: number;
  readonly diagnostic: Diagnostic;
}

/** The text of the line below the program: the number of places, and those in the cursor's line. */
interface Said {
  readonly marked: readonly Marked[];
  readonly errors: number;
  readonly hints: number;
  /** True if one of the hints is on the program itself, whatever microcomputer it runs on. */
  readonly ofProgram: boolean;
  readonly here: readonly Diagnostic[];
}

const said = StateField.define<Said>({
  create: whatToSay,
  update(value, transaction) {
    const checked = transaction.effects.some((effect) => effect.is(setDiagnosticsEffect));
    return checked || transaction.docChanged || transaction.selection !== undefined
      ? whatToSay(transaction.state)
      : value;
  },
});

function markedIn(state: EditorState): readonly Marked[] {
  const marked: Marked[] = [];
  forEachDiagnostic(state, (diagnostic, from, to) => marked.push({ from, to, diagnostic }));
  return marked.sort((a, b) => a.from - b.from);
}

function whatToSay(state: EditorState): Said {
  const marked = markedIn(state);
  const line = state.doc.lineAt(state.selection.main.head);
  const here = marked.filter(({ from }) => from >= line.from && from <= line.to).map(({ diagnostic }) => diagnostic);
  const errors = marked.filter(({ diagnostic }) => diagnostic.severity === 'warning').length;
  const ofProgram = marked.some(({ diagnostic }) => diagnostic.severity === 'hint');
  return { marked, errors, hints: marked.length - errors, ofProgram, here };
}

/** A sign beside a line: `!` where the device stops, `i` where it may come to another result, and for a slip. */
class Sign extends GutterMarker {
  constructor(
    private readonly isHint: boolean,
    private readonly message: string,
  ) {
    super();
  }

  override eq(other: Sign): boolean {
    return this.isHint === other.isHint && this.message === other.message;
  }

  override toDOM(): HTMLElement {
    const dom = document.createElement('span');
    dom.className = this.isHint ? 'cm-deviceMark cm-deviceMark-hint' : 'cm-deviceMark';
    dom.textContent = this.isHint ? 'i' : '!';
    dom.title = this.message;
    dom.setAttribute('aria-hidden', 'true'); // the line below the text says it
    return dom;
  }
}

/** True for a hint: on the device or on the program itself. */
const isHintOnly = ({ severity }: Diagnostic): boolean => severity !== 'warning';

/** One sign for each line that has marks, the graver one. */
function signsOf(state: EditorState): RangeSet<GutterMarker> {
  const lines = new Map<number, Diagnostic[]>();
  for (const { from, diagnostic } of state.field(said).marked) {
    const line = state.doc.lineAt(from).from;
    lines.set(line, [...(lines.get(line) ?? []), diagnostic]);
  }
  const signs = [...lines].map(([line, marks]) => {
    const isHint = marks.every(isHintOnly);
    return new Sign(isHint, marks.map(({ message }) => message).join('\n')).range(line);
  });
  return RangeSet.of(signs, true);
}

/** Puts the cursor on the next marked place, the first after the last. */
const goToNext: Command = (view) => {
  const marked = markedIn(view.state);
  const { head } = view.state.selection.main;
  const line = view.state.doc.lineAt(head);
  const next = marked.find(({ from }) => from > line.to) ?? marked[0];
  if (next === undefined) return false;
  view.dispatch({
    selection: { anchor: next.from },
    effects: EditorView.scrollIntoView(next.from, { y: 'center' }),
    userEvent: 'select',
  });
  view.focus();
  return true;
};

/**
 * A line below the text: it counts what would not run on the device, and explains what is in the cursor's line. So the
 * explanation is there for a finger, a keyboard (F8 goes to the next place) and a screen reader too.
 *
 * @param board present name of the microcomputer
 */
export function devicePanel(board: () => string): Extension {
  const create = (view: EditorView): Panel => panelOf(view, board);
  return [
    said,
    showPanel.compute([said], (state) => {
      const { errors, hints, here } = state.field(said);
      return errors > 0 || hints > 0 || here.length > 0 ? create : null;
    }),
    deviceGutter.compute([said], signsOf),
    keymap.of([{ key: 'F8', run: goToNext }]),
  ];
}

function panelOf(view: EditorView, board: () => string): Panel {
  const dom = document.createElement('div');
  dom.className = 'cm-devicePanel';
  dom.dataset['testid'] = 'device-check';
  const text = document.createElement('p');
  text.setAttribute('aria-live', 'polite');
  const next = document.createElement('button');
  next.type = 'button';
  next.addEventListener('click', () => goToNext(view));
  // A press must not take the cursor out of the text: the touch keyboard would close and open again.
  next.addEventListener('mousedown', (event) => event.preventDefault());
  const icon = iconOf();
  const mend = document.createElement('button');
  mend.type = 'button';
  mend.addEventListener('mousedown', (event) => event.preventDefault());
  let change: Action | undefined;
  mend.addEventListener('click', () => change?.apply(view, 0, 0));
  const ways = document.createElement('span');
  ways.append(mend, next);
  dom.append(icon.dom, text, ways);
  const show = (state: EditorState): void => {
    const { errors, hints, here } = state.field(said);
    const sentence =
      here.length > 0 ? here.map(({ message }) => message).join('\n') : summary(state.field(said), board());
    const isHint = here.length > 0 ? here.every(isHintOnly) : errors === 0;
    icon.show(isHint);
    dom.classList.toggle('cm-devicePanel-hint', isHint);
    if (text.textContent !== sentence) text.textContent = sentence;
    change = here.flatMap(({ actions }) => actions ?? [])[0];
    mend.hidden = change === undefined;
    if (change !== undefined && mend.textContent !== change.name) mend.textContent = change.name;
    const label = t(here.length === 0 ? words.show : words.next);
    if (next.textContent !== label) next.textContent = label;
    next.hidden = here.length > 0 && here.length === errors + hints;
  };
  show(view.state);
  return { dom, update: ({ state }) => show(state) };
}

function summary({ errors, hints, ofProgram }: Said, board: string): string {
  if (errors === 0 && ofProgram) return t(hints === 1 ? words.oneOfProgram : words.ofProgram, { count: hints });
  if (errors === 0) return t(hints === 1 ? words.oneHint : words.hints, { count: hints, board });
  return t(errors === 1 ? words.one : words.many, { count: errors, board });
}

function iconOf(): { readonly dom: SVGElement; readonly show: (isHint: boolean) => void } {
  const space = 'http://www.w3.org/2000/svg';
  const dom = document.createElementNS(space, 'svg');
  const path = document.createElementNS(space, 'path');
  dom.setAttribute('viewBox', '0 0 24 24');
  dom.setAttribute('aria-hidden', 'true');
  dom.append(path);
  return { dom, show: (isHint) => path.setAttribute('d', isHint ? mdiInformationOutline : mdiAlertOutline) };
}
