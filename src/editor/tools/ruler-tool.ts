import { endOf, isTap, startOf } from '../drag';
import type { Tool } from './tool';

/** Measures from where the drag begins to where it is. It changes nothing. */
export const rulerTool: Tool = {
  id: 'ruler',
  cursor: 'crosshair',
  edit: () => null,
  marks: (drag, _context, isDown) => {
    const to = endOf(drag);
    // A tap shows x and y of the place itself.
    return isDown ? [{ type: 'measure', from: isTap(drag) ? to : startOf(drag), to }] : [];
  },
};
