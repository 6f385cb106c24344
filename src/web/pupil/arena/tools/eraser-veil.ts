import type { Tool, ToolContext } from '#editor/tools/tool';
import type { Ink } from './gesture';

/** Beyond this many points of lines, the eraser shows its path, and the remaining lines at the end. Chosen: 5 ms. */
const MANY_POINTS = 4000;

/** The path of an eraser over many lines, in the colour of paper: cutting them for each picture takes too long. */
export function eraserInk({ id }: Tool, { scene, options }: ToolContext): Omit<Ink, 'path'> | null {
  if (id !== 'eraser') return null;
  let points = 0;
  for (const object of scene.objects) if (object.type === 'stroke') points += object.points.length;
  return points < MANY_POINTS ? null : { width: options.eraserWidth, color: 'white' };
}
