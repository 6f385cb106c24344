import {
  mdiCursorMove,
  mdiEraser,
  mdiFlagCheckered,
  mdiFormatText,
  mdiGrid,
  mdiPencil,
  mdiRobot,
  mdiRotateRight,
  mdiRuler,
  mdiSquareRounded,
  mdiVectorPolylineEdit,
  mdiWall,
} from '@mdi/js';
import type { ToolId } from '#editor/tools/tool';

/** The sign of each tool, as paths of 24 units. */
export const toolSigns: Readonly<Record<ToolId, string>> = {
  select: mdiCursorMove,
  rotate: mdiRotateRight,
  points: mdiVectorPolylineEdit,
  pen: mdiPencil,
  eraser: mdiEraser,
  block: mdiSquareRounded,
  wall: mdiWall,
  maze: mdiGrid,
  zone: mdiFlagCheckered,
  label: mdiFormatText,
  start: mdiRobot,
  ruler: mdiRuler,
};

/** Side of a cursor in px: browsers take up to 32 without asking. */
const SIDE = 32;
/** Hot spot of a cursor's crosshair, in px from its upper left corner. */
const HOT = 9;

/**
 * The CSS cursor of a tool: a crosshair with the tool's sign beside it. `select` and `points` have the usual arrow,
 * which people know.
 */
export function toolCursor(tool: ToolId): string {
  if (tool === 'select' || tool === 'points') return 'default';
  const cross = `M${String(HOT)} 1v6M${String(HOT)} 11v6M1 ${String(HOT)}h6M11 ${String(HOT)}h6`;
  const svg =
    `<svg xmlns="http://www.w3.org/2000/svg" width="${String(SIDE)}" height="${String(SIDE)}">` +
    `<g fill="none" stroke-linecap="round"><path d="${cross}" stroke="#fff" stroke-width="4"/>` +
    `<path d="${cross}" stroke="#1B1F24" stroke-width="1.8"/></g>` +
    `<path transform="translate(14 14) scale(.72)" d="${toolSigns[tool]}" fill="#1B1F24" stroke="#fff" ` +
    `stroke-width="4" paint-order="stroke" stroke-linejoin="round"/></svg>`;
  return `url("data:image/svg+xml,${encodeURIComponent(svg)}") ${String(HOT)} ${String(HOT)}, crosshair`;
}
