import { RangeSet, StateEffect, StateField, type EditorState, type Extension, type Text } from '@codemirror/state';
import {
  Decoration,
  EditorView,
  gutterLineClass,
  GutterMarker,
  ViewPlugin,
  type DecorationSet,
} from '@codemirror/view';

import type { Shown } from '#vm/debug/shown';
import { showTapped, values } from './values';

/** The lines with break points, counted from 1. */
const setPoints = StateEffect.define<readonly number[]>();
/** The line where the program is halted, counted from 1; `null`: none of this file. */
const setStanding = StateEffect.define<number | null>();

class PointMark extends GutterMarker {
  override readonly elementClass = 'cm-breakPoint';
}
class StandingMark extends GutterMarker {
  override readonly elementClass = 'cm-standing';
}
const pointMark = new PointMark();
const standingMark = new StandingMark();
const standingLine = Decoration.line({ class: 'cm-standingLine' });

const isWithin = (doc: Text, line: number): boolean => line >= 1 && line <= doc.lines;

function pointsAt(doc: Text, lines: readonly number[]): RangeSet<GutterMarker> {
  const ranges = lines.filter((line) => isWithin(doc, line)).map((line) => pointMark.range(doc.line(line).from));
  return RangeSet.of(ranges, true);
}

/** Break points move with their lines. */
const points = StateField.define<RangeSet<GutterMarker>>({
  create: () => RangeSet.empty,
  update(before, transaction) {
    let next = before;
    if (transaction.docChanged)
      next = pointsAt(transaction.newDoc, linesOf(before.map(transaction.changes), transaction.newDoc));
    for (const effect of transaction.effects)
      if (effect.is(setPoints)) next = pointsAt(transaction.newDoc, effect.value);
    return next;
  },
  provide: (field) => gutterLineClass.from(field),
});

function linesOf(marks: RangeSet<GutterMarker>, doc: Text): number[] {
  const lines: number[] = [];
  marks.between(0, doc.length, (from) => {
    lines.push(doc.lineAt(from).number);
  });
  return [...new Set(lines)];
}

interface Standing {
  readonly line: DecorationSet;
  readonly mark: RangeSet<GutterMarker>;
}
const nowhere: Standing = { line: Decoration.none, mark: RangeSet.of<GutterMarker>([]) };

const standing = StateField.define<Standing>({
  create: () => nowhere,
  update(before, transaction) {
    let next = transaction.docChanged ? nowhere : before; // the program that runs has other lines from now on
    for (const effect of transaction.effects)
      if (effect.is(setStanding)) next = standingAt(transaction.newDoc, effect.value);
    return next;
  },
  provide: (field) => [
    EditorView.decorations.from(field, ({ line }) => line),
    gutterLineClass.from(field, ({ mark }) => mark),
  ],
});

function standingAt(doc: Text, line: number | null): Standing {
  if (line === null || !isWithin(doc, line)) return nowhere;
  const { from } = doc.line(line);
  return { line: Decoration.set([standingLine.range(from)]), mark: RangeSet.of(standingMark.range(from)) };
}

/** Room above and below a line that is brought into view, in px; less where the editor is low, else it would be pushed out. */
export const marginOf = (heightPx: number, linePx: number): number =>
  Math.max(0, Math.min(40, (heightPx - linePx) / 2));

function toLine({ scrollDOM, defaultLineHeight }: EditorView, from: number): StateEffect<unknown> {
  return EditorView.scrollIntoView(from, {
    y: 'nearest',
    yMargin: marginOf(scrollDOM.clientHeight, defaultLineHeight),
  });
}

/** A bar below that comes with the first stop takes room from the editor: its line is then brought into view again. */
const staysInView = ViewPlugin.define((view) => {
  let heightPx = view.scrollDOM.clientHeight;
  // The editor itself hears of no change of its size so soon after one of its content.
  const observer = new ResizeObserver(() => {
    const nowPx = view.scrollDOM.clientHeight;
    const stands = view.state.field(standing, false)?.line.iter();
    if (nowPx < heightPx && stands?.value) view.dispatch({ effects: toLine(view, stands.from) });
    heightPx = nowPx;
  });
  observer.observe(view.scrollDOM);
  return { destroy: () => observer.disconnect() };
});

const look = EditorView.theme({
  // In the column of the marks, which is there anyway.
  '.cm-deviceGutter .cm-breakPoint': { position: 'relative' },
  '.cm-deviceGutter .cm-breakPoint::before': {
    content: '""',
    position: 'absolute',
    left: '5px',
    top: 'calc(50% - 6px)',
    width: '12px',
    height: '12px',
    borderRadius: '50%',
    backgroundColor: 'var(--stop)',
  },
  '.cm-tooltip .cm-valueCard': {
    maxWidth: '420px',
    padding: '6px 10px',
    overflow: 'hidden',
    fontFamily: 'var(--mono)',
    fontSize: '13.5px',
    textOverflow: 'ellipsis',
    whiteSpace: 'nowrap',
  },
  '.cm-tooltip .cm-valueCard span': { color: 'var(--text-3)' },
  '.cm-standingLine, &.cm-focused .cm-activeLine.cm-standingLine': {
    backgroundColor: 'var(--accent-soft)',
  },
  '.cm-lineNumbers .cm-standing, &.cm-focused .cm-lineNumbers .cm-standing.cm-activeLineGutter': {
    backgroundColor: 'var(--accent-soft)',
    color: 'var(--accent)',
    fontWeight: '700',
  },
});

/**
 * The debugger's marks in an editor.
 *
 * @param onMove called with the break points' lines whenever an edit has moved some
 * @param valueOf the value of a name while the program is halted
 */
export const stopMarks = (
  onMove: (lines: readonly number[]) => void,
  valueOf: (name: string) => Shown | null,
): Extension => [
  values(valueOf),
  points,
  standing,
  staysInView,
  calmStops,
  look,
  EditorView.updateListener.of(({ docChanged, startState, state }) => {
    if (!docChanged || startState.field(points, false) === undefined) return;
    const [before, now] = [pointLines(startState), pointLines(state)];
    if (before.join() !== now.join()) onMove(now);
  }),
];

/** The lines with break points, as the editor has them. */
export function pointLines(state: EditorState): readonly number[] {
  const marks = state.field(points, false);
  return marks === undefined ? [] : linesOf(marks, state.doc);
}

/**
 * Shortest time between two changes of the marks, in ms: nobody sees more lines while dragging through time, and each
 * costs.
 */
const CALM_MS = 200;

/** Shows marks of an editor, five times a second at most; the last ones always. */
class CalmStops {
  /** The marks to show once the time since the last change is over. */
  private next: Marks | null = null;
  private resting: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly view: EditorView) {}

  show(...[lines, line, isNew]: Marks): void {
    if (this.resting !== undefined) {
      this.next = [lines, line, isNew !== false || (this.next !== null && this.next[2] !== false)];
      return;
    }
    showStops(this.view, lines, line, isNew);
    this.resting = setTimeout(() => {
      this.resting = undefined;
      const { next } = this;
      this.next = null;
      if (next !== null) this.show(...next);
    }, CALM_MS);
  }

  destroy(): void {
    clearTimeout(this.resting);
  }
}
const calmStops = ViewPlugin.fromClass(CalmStops);

/** The same as `showStops`, but five times a second at most; the last one always comes. */
export const showStopsCalmly = (view: EditorView, ...marks: Marks): void => view.plugin(calmStops)?.show(...marks);

/** The lines with break points, the one where the program is halted, and whether it has just been halted there. */
type Marks = [lines: readonly number[], line: number | null, isNew?: boolean];

/**
 * Shows break points and the line where the program is halted.
 *
 * @param isNew true if the program has just been halted there: the line is brought into view
 */
export function showStops(view: EditorView, lines: readonly number[], line: number | null, isNew = true): void {
  const effects: StateEffect<unknown>[] = [setPoints.of(lines), setStanding.of(line), showTapped.of(null)];
  if (isNew && line !== null && isWithin(view.state.doc, line))
    effects.push(toLine(view, view.state.doc.line(line).from));
  view.dispatch({ effects });
}
