import { blockTool } from './block-tool';
import { eraserTool } from './eraser-tool';
import { labelTool } from './label-tool';
import { mazeTool } from './maze-tool';
import { pointsTool } from '../lines/points-tool';
import { penTool } from './pen-tool';
import { rotateTool } from './rotate-tool';
import { rulerTool } from './ruler-tool';
import { selectTool } from './select-tool';
import { startTool } from './start-tool';
import type { Tool, ToolId } from './tool';
import { wallTool } from './wall-tool';
import { zoneTool } from './zone-tool';

/** All tools by their id. Loaded late, as one piece. */
export const tools: Readonly<Record<ToolId, Tool>> = {
  select: selectTool,
  rotate: rotateTool,
  points: pointsTool,
  pen: penTool,
  eraser: eraserTool,
  block: blockTool,
  wall: wallTool,
  maze: mazeTool,
  zone: zoneTool,
  label: labelTool,
  start: startTool,
  ruler: rulerTool,
};
