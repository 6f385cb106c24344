import type { Point } from '#scene/scene';

import { QR_RIM } from '../../../kit/links/qr-code';
import { emsOf } from '../task/letter-widths';
import { BASE, breakPages, LEADING, setRows, type PaperBlock, type PlacedRow } from '../task/set-rows';
import { heading, plain, taskBlocks, titleBlock, type PaperTask } from '../task/task-blocks';
import { barMm, drawnCourse, type DrawnCourse } from './course-scale';
import type { PaperQr } from './paper-qr';

/** A sheet of A4, in mm. */
export const SHEET_MM = [210, 297] as const;

/** Space for pupils to write: none, three lines for each question, or lines or squares to the foot of the sheet. */
export const spaces = ['none', 'some', 'lines', 'squares'] as const;
export type Space = (typeof spaces)[number];

/** The content of a worksheet, every word in the language of the reader. */
export interface SheetContent {
  /** The task; without one it has the title alone. */
  readonly task: PaperTask;
  /** Width and height of the course, in mm. */
  readonly courseMm: Point;
  /** The code that opens the task; `null`: none. */
  readonly qr: PaperQr | null;
  readonly space: Space;
  /** Author and licence, at the foot; empty: none are said. */
  readonly credit: string;
  readonly words: SheetWords;
}

/** The words of the sheet itself. */
export interface SheetWords {
  /** Before the lines at the top: who, which class, when. */
  readonly name: string;
  readonly class: string;
  readonly date: string;
  /** Below the code. */
  readonly open: string;
  /** Over the room to write: before the run, and after it. */
  readonly questions: readonly string[];
  /** The text below the drawing. */
  readonly scale: (scale: number) => string;
}

/** A rectangle, in mm from the sheet's upper left corner. */
export interface Box {
  readonly at: Point;
  readonly size: Point;
}

/** Something on a sheet. Of rows, `at` is the upper left corner of the text they belong to. */
export type Mark =
  | { readonly kind: 'row'; readonly row: PlacedRow; readonly at: Point }
  | { readonly kind: 'line'; readonly from: Point; readonly to: Point; readonly isStrong: boolean }
  | ({ readonly kind: 'course' | 'qr' | 'squares' } & Box);

/** The sheets, and how the course is drawn on one of them. */
export interface SheetLayout {
  readonly pages: readonly (readonly Mark[])[];
  readonly course: DrawnCourse;
}

/** White margin of a sheet, in mm: the page number is at the foot. */
const MARGIN = { side: 16, top: 14, foot: 15 } as const;
const WIDTH = SHEET_MM[0] - 2 * MARGIN.side;
const HEIGHT = SHEET_MM[1] - MARGIN.top - MARGIN.foot;

/** Type sizes in mm: 11 pt, and 9.2 pt for what stands at the side. Nothing is smaller. */
const TEXT_MM = 3.9;
export const SIDE_MM = 3.25;

/** From one line to write on to the next: chosen, as in the exercise books of the third form. */
const WRITE_MM = 9;
export const SQUARE_MM = 5;

/** Room over a question, and its heading. */
const ABOVE_MM = 5;
const QUESTION_MM = ABOVE_MM + 1.15 * LEADING * TEXT_MM;

/** Lines of a question where only some are wanted. */
const SOME = 3;

/**
 * Less high than this a drawing goes on to the next page, unless the course itself is flat; a sheet that has room for everything
 * is worth a smaller one. Chosen: a course of 120 × 90 cm then is 60 mm wide.
 */
const [LEAST_DRAWING_MM, LEAST_ON_ONE_SHEET_MM] = [60, 45];

/** Room between the text and the drawing, and what stands below the drawing. */
const GAP_MM = 5;
const CAPTION_MM = 2 + LEADING * SIDE_MM;

/** The pages in the making: how far the last one is filled, from the top of its text. */
interface Draft {
  readonly pages: Mark[][];
  endMm: number;
}

/**
 * Lays a worksheet out on as many sheets of A4 as it needs: title and fields for the name, the task, the course as
 * large as there is room, lines to write on.
 *
 * @param clean changes each block before it is measured: a PDF's fonts lack some signs
 */
export function layOutSheet(content: SheetContent, clean = (block: PaperBlock): PaperBlock => block): SheetLayout {
  const draft: Draft = { pages: [[]], endMm: 0 };
  const set = (blocks: readonly PaperBlock[], widthMm: number) => setRows(blocks.map(clean), widthMm);
  placeHead(draft, content, set);
  placeTask(draft, content.task, set);
  const course = placeCourse(draft, content, set);
  placeSpace(draft, content, set);
  placeFeet(draft, content, set);
  return { pages: draft.pages, course };
}

type SetRows = (blocks: readonly PaperBlock[], widthMm: number) => ReturnType<typeof setRows>;

/** A place in the text's frame on the sheet. */
const onSheet = ([x, y]: Point): Point => [MARGIN.side + x, MARGIN.top + y];

function put(draft: Draft, ...marks: readonly Mark[]): void {
  draft.pages.at(-1)?.push(...marks);
}

function newPage(draft: Draft): void {
  draft.pages.push([]);
  draft.endMm = 0;
}

/** Rows without a page's end between them. @returns where they end, in mm from `at` */
function putRows(draft: Draft, rows: ReturnType<SetRows>, at: Point): number {
  const [placed = []] = breakPages(rows, Infinity);
  put(draft, ...placed.map((row) => ({ kind: 'row', row, at: onSheet(at) }) as const));
  const last = placed.at(-1);
  return last === undefined ? 0 : last.topMm + last.row.heightMm;
}

/** Title, code, and the lines for name, class and date. */
function placeHead(draft: Draft, { task, qr, words }: SheetContent, set: SetRows): void {
  const codeMm = qr === null ? 0 : (qr.size - 2 * QR_RIM) * qr.squareMm;
  const leftMm = qr === null ? WIDTH : WIDTH - codeMm - 8;
  const titleMm = putRows(draft, set(titleBlock(task.title, TEXT_MM), leftMm), [0, 0]);
  let codeEndMm = 0;
  if (qr !== null) {
    const rimMm = QR_RIM * qr.squareMm;
    const at = onSheet([WIDTH - codeMm - rimMm, -rimMm]);
    put(draft, { kind: 'qr', at, size: [codeMm + 2 * rimMm, codeMm + 2 * rimMm] });
    const below = set([plain(words.open, SIDE_MM)], codeMm);
    codeEndMm = codeMm + 1.5 + putRows(draft, below, [WIDTH - codeMm, codeMm + 1.5]);
  }
  const { name, class: form, date } = words;
  const isHigh = codeEndMm - titleMm > 3 * 11;
  const fields =
    qr === null ? [[name, form, date]] : isHigh ? [[name], [form], [date]] : [[name], [form, date]]; // prettier-ignore
  const stepMm = Math.max(10.5, Math.min(14, (codeEndMm - titleMm) / fields.length));
  fields.forEach((labels, index) => placeFields(draft, labels, titleMm + (index + 0.3) * stepMm, leftMm, set));
  draft.endMm = Math.max(codeEndMm, titleMm + fields.length * stepMm) + 1;
}

/** Lines to fill in, side by side, the first the longest. */
function placeFields(draft: Draft, labels: readonly string[], topMm: number, widthMm: number, set: SetRows): void {
  const gapMm = 5;
  const parts = labels.length + (labels.length > 2 ? 1 : 0);
  const partMm = (widthMm - (labels.length - 1) * gapMm) / parts;
  let left = 0;
  labels.forEach((label, index) => {
    const isLong = index === 0 && labels.length > 2;
    const right = left + (isLong ? 2 : 1) * partMm;
    putRows(draft, set([plain(label, TEXT_MM)], right - left), [left, topMm]);
    const y = topMm + BASE * TEXT_MM + 0.6;
    const from = left + emsOf(label, 'text') * TEXT_MM + 2;
    put(draft, { kind: 'line', from: onSheet([from, y]), to: onSheet([right, y]), isStrong: true });
    left = right + gapMm;
  });
}

/** Places the card of the task, on as many pages as it needs. */
function placeTask(draft: Draft, task: PaperTask, set: SetRows): void {
  const rows = set(taskBlocks({ ...task, title: '' }, WIDTH, TEXT_MM), WIDTH);
  breakPages(rows, HEIGHT, draft.endMm).forEach((placed, page) => {
    if (page > 0) newPage(draft);
    put(draft, ...placed.map((row) => ({ kind: 'row', row, at: onSheet([0, 0]) }) as const));
    const last = placed.at(-1);
    if (last !== undefined) draft.endMm = last.topMm + last.row.heightMm;
  });
}

/** Room that the questions need, at least. */
function spaceMm({ space, words }: SheetContent): number {
  return space === 'none' ? 0 : words.questions.length * (QUESTION_MM + SOME * WRITE_MM);
}

/**
 * The course, with the room to write below it on the same page where that works. Where the rest of the page is too low for a
 * drawing that shows anything, it goes on to the next.
 */
function placeCourse(draft: Draft, content: SheetContent, set: SetRows): DrawnCourse {
  const { courseMm, words } = content;
  const drawn = (roomMm: number): DrawnCourse => drawnCourse(courseMm, [WIDTH, roomMm]);
  const roomFor = (belowMm: number): number => HEIGHT - draft.endMm - GAP_MM - CAPTION_MM - belowMm;
  const wholeMm = drawn(HEIGHT - CAPTION_MM).size[1];
  const [withSpace, alone] = [roomFor(spaceMm(content)), roomFor(0)];
  const isOneSheet = withSpace >= Math.min(LEAST_ON_ONE_SHEET_MM, wholeMm);
  const room = isOneSheet ? withSpace : alone >= Math.min(LEAST_DRAWING_MM, wholeMm) ? alone : undefined;
  if (room === undefined) newPage(draft);
  const course = drawn(room ?? HEIGHT - CAPTION_MM - spaceMm(content));
  const top = room === undefined ? 0 : draft.endMm + GAP_MM;
  const left = (WIDTH - course.size[0]) / 2;
  put(draft, { kind: 'course', at: onSheet([left, top]), size: course.size });
  const below = top + course.size[1] + 2;
  placeBar(draft, course.scale, below, set);
  const captionMm = putRows(draft, set([plain(words.scale(course.scale), SIDE_MM)], WIDTH - 70), [0, below]);
  draft.endMm = below + captionMm;
  return course;
}

/** A bar for the scale with its length in cm of the course, at the right. */
function placeBar(draft: Draft, scale: number, topMm: number, set: SetRows): void {
  const lengthMm = barMm(scale);
  const [from, to] = [WIDTH - lengthMm / scale, WIDTH];
  const y = topMm + BASE * SIDE_MM;
  const line = (start: Point, end: Point): Mark => ({
    ...{ kind: 'line', from: onSheet(start), to: onSheet(end), isStrong: true },
  });
  put(draft, line([from, y], [to, y]), line([from, y - 2], [from, y]), line([to, y - 2], [to, y]));
  const label = `${String(lengthMm / 10)} cm`;
  putRows(draft, set([plain(label, SIDE_MM)], 30), [from - emsOf(label, 'text') * SIDE_MM - 1.5, topMm]);
}

/** The questions, each with lines or squares below it. */
function placeSpace(draft: Draft, content: SheetContent, set: SetRows): void {
  const { space, words } = content;
  if (space === 'none') return;
  if (draft.endMm + spaceMm(content) > HEIGHT) newPage(draft);
  const eachMm = (HEIGHT - draft.endMm) / words.questions.length;
  for (const question of words.questions) {
    const top = draft.endMm + ABOVE_MM;
    const below = top + putRows(draft, set([heading(question, TEXT_MM)], WIDTH), [0, top]);
    const rest = eachMm - QUESTION_MM;
    if (space === 'squares') {
      const count = Math.floor((rest - 1.5) / SQUARE_MM);
      const size: Point = [Math.floor(WIDTH / SQUARE_MM) * SQUARE_MM, count * SQUARE_MM];
      put(draft, { kind: 'squares', at: onSheet([0, below + 1.5]), size });
      draft.endMm = below + 1.5 + size[1];
    } else {
      const count = space === 'some' ? SOME : Math.max(SOME, Math.floor(rest / WRITE_MM + 0.01));
      for (let line = 1; line <= count; line += 1) {
        const y = below + line * WRITE_MM;
        put(draft, { kind: 'line', from: onSheet([0, y]), to: onSheet([WIDTH, y]), isStrong: false });
      }
      draft.endMm = below + count * WRITE_MM;
    }
  }
}

/** Author and licence at the foot of each page; on each of several also of which sheet it is, and which page. */
function placeFeet({ pages }: Draft, { task, credit }: SheetContent, set: SetRows): void {
  const y = SHEET_MM[1] - MARGIN.foot + 4;
  const several = pages.length > 1;
  const said = [several ? task.title : '', credit].filter((text) => text !== '').join(' · ');
  pages.forEach((page, index) => {
    const number = several ? `${String(index + 1)}/${String(pages.length)}` : '';
    const numberMm = emsOf(number, 'text') * SIDE_MM;
    const foot = (text: string, x: number, widthMm: number): void => {
      const [row] = text === '' ? [] : set([plain(text, SIDE_MM)], widthMm);
      if (row !== undefined) page.push({ kind: 'row', row: { row, topMm: 0 }, at: [MARGIN.side + x, y] });
    };
    foot(said, 0, WIDTH - 20);
    foot(number, WIDTH - numberMm, 20);
  });
}
