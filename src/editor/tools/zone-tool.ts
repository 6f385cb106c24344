import { putting } from './block-tool';
import { cornerByCorner, type Wish } from './corner-polygon';
import type { Tool, ToolContext } from './tool';

/** Marks a field on the floor: a tap one of the usual size, a drag the rectangle (or the ellipse in it), a polygon as blocks. */
export const zoneTool: Tool = {
  id: 'zone',
  putsDown: true,
  cursor: 'crosshair',
  edit: (drag, context) => putting(wishOf(context), drag, context),
  ...cornerByCorner((context) => wishOf(context)),
};

const wishOf = ({ options }: ToolContext): Wish => ({ type: options.zone, shape: options.zoneShape });
