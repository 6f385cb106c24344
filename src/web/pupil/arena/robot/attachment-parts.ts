import { radOf } from '#core/angle';
import type { Vec } from '#core/geometry';
import { readRobotDrawing, type Box, type RobotDrawing } from './robot-drawing';
import { elementsOf, readSvgTree, type SvgElement } from '../picture/svg-tree';

/** A part of a drawing that is drawn separately. */
export interface AttachmentPart {
  /** Id of its group. */
  readonly id: string;
  /** A document with this part alone. */
  readonly svg: string;
  readonly viewBox: Box;
  /** Its centre of rotation, in drawing units. */
  readonly pivot: Vec;
  /** Its default rotation, counter-clockwise. */
  readonly restRad: number;
}

/** The parts of an attachment's drawing, lowest first; see `#attachments/drawings` for its rules. */
export function partsOf(drawing: string): readonly AttachmentPart[] {
  const root = rootOf(drawing);
  const { viewBox } = readRobotDrawing(drawing);
  return (root?.children ?? [])
    .filter(({ name }) => name === 'g')
    .map((group) => ({
      id: group.attributes['id'] ?? '',
      svg: documentOf(drawing, root, group),
      viewBox,
      pivot: pairOf(group.attributes['data-pivot']) ?? { x: 0, y: 0 },
      restRad: radOf(Number(group.attributes['data-rest'] ?? 0) || 0),
    }));
}

/** Id of the group of a robot's drawing that a servo may turn. */
const SONAR_ID = 'ultrasonic';

/**
 * A robot's distance sensor as a part that turns, and the robot's drawing without it; `null` when the drawing has none.
 * It turns about the middle of its board, the first `<rect>` in its group.
 */
export function sonarOf({ svg, viewBox }: Pick<RobotDrawing, 'svg' | 'viewBox'>): {
  readonly head: AttachmentPart;
  readonly body: Pick<AttachmentPart, 'svg' | 'viewBox'>;
} | null {
  const root = rootOf(svg);
  const group = root?.children.find(({ attributes }) => attributes['id'] === SONAR_ID);
  const board = group && [...elementsOf(group)].find(({ name }) => name === 'rect');
  if (group === undefined || board === undefined) return null;
  const middle = (at: string, extent: string): number =>
    Number(board.attributes[at] ?? 0) + Number(board.attributes[extent] ?? 0) / 2;
  const shift = pairOf(/^translate\(([^)]*)\)$/.exec(group.attributes['transform'] ?? '')?.[1]) ?? { x: 0, y: 0 };
  const pivot = { x: shift.x + middle('x', 'width'), y: shift.y + middle('y', 'height') };
  return {
    head: { id: 'sonar', svg: documentOf(svg, root, group), viewBox, pivot, restRad: 0 },
    body: { svg: svg.slice(0, group.start) + svg.slice(group.end), viewBox },
  };
}

function rootOf(svg: string): SvgElement | undefined {
  return readSvgTree(svg).children.find(({ name }) => name === 'svg');
}

/** The root's own tag, its definitions and one group. */
function documentOf(svg: string, root: SvgElement | undefined, group: SvgElement): string {
  const open = /<svg\b[^>]*>/.exec(svg)?.[0] ?? '<svg>';
  const defs = root?.children.find(({ name }) => name === 'defs');
  return `${open}${defs === undefined ? '' : svg.slice(defs.start, defs.end)}${svg.slice(group.start, group.end)}</svg>`;
}

function pairOf(text: string | undefined): Vec | null {
  const [x, y] = (text ?? '')
    .trim()
    .split(/[\s,]+/)
    .map(Number);
  return Number.isFinite(x) && text !== undefined ? { x: x ?? 0, y: y ?? 0 } : null;
}
