import { putting } from './block-tool';
import type { Tool } from './tool';

/** Marks a field on the floor: a tap one of the usual size, a drag the rectangle (or the ellipse in it). */
export const zoneTool: Tool = {
  id: 'zone',
  putsDown: true,
  cursor: 'crosshair',
  edit: (drag, context) => putting(context.options.zone, drag, context),
};
