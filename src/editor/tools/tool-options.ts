import { sceneDefaults, sceneLimits, type Point, type SceneObject } from '#scene/scene';
import type { ToolOptions } from './tool';

/** Initial options of the tools. */
export const usualToolOptions: ToolOptions = {
  penWidth: sceneDefaults.width,
  penColor: sceneDefaults.color,
  penShape: 'free',
  eraser: 'all',
  eraserWidth: 30, // chosen: takes a line of 20 mm in one go
  block: 'block',
  blockShape: 'rectangle',
  blockSize: [50, 50], // chosen: as wide as a hand of the robots can push without losing it
  blockHeight: null,
  blockColor: null,
  moverWay: 'to-and-fro',
  moverSpeed: sceneDefaults.speed,
  moverWait: 0,
  moverSpin: 0,
  moverSpiked: sceneDefaults.spiked,
  wallThickness: sceneDefaults.thickness,
  wallHeight: null,
  wallColor: null,
  wallSnaps: true,
  mazeCell: 150, // chosen: all robots turn round in it, and the usual arena is 8 × 6 such cells
  zone: 'target',
  zoneShape: 'rectangle',
  zoneBlocks: sceneDefaults.blocks,
  zoneBlockColor: null,
  labelText: '',
  labelHeight: sceneDefaults.labelHeight,
  several: false,
  catches: 'frame',
};

/** Bounds of a number beside a tool, and the step of its − and + buttons. */
export interface OptionRange {
  readonly min: number;
  readonly max: number;
  readonly step: number;
}

/** Ranges of the options, in mm, mm/s, s, °/s or a count. Bounds: those of a course (`sceneLimits`), or chosen. */
export const toolOptionRanges = {
  penWidth: { ...sceneLimits.widthMm, step: 1 },
  eraserWidth: { min: 5, max: 300, step: 5 },
  blockSide: { ...sceneLimits.blockMm, step: 5 },
  moverSpeed: { ...sceneLimits.speedMmS, step: 5 },
  moverWait: { ...sceneLimits.waitSeconds, step: 0.5 },
  moverSpin: { ...sceneLimits.spinDegS, step: 15 },
  wallThickness: { ...sceneLimits.thicknessMm, step: 1 },
  height: { ...sceneLimits.heightMm, step: 5 },
  mazeCell: { min: 50, max: 1000, step: 10 },
  zoneBlocks: { ...sceneLimits.blocks, step: 1 },
  labelHeight: { ...sceneLimits.labelMm, step: 5 },
} as const satisfies Record<string, OptionRange>;

/** Widths of the pen that have a button of their own, in mm: narrow, usual and wide tape. */
export const penWidths: readonly number[] = [15, 20, 30];

/** Widths of the eraser that have a button of their own, in mm. */
export const eraserWidths: readonly number[] = [15, 30, 60];

/** The kinds that the tool for blocks places, in the order in which it offers them. */
export const blockKinds = ['block', 'fixed-block', 'spikes', 'mover'] as const satisfies readonly SceneObject['type'][];

/** Sizes of blocks that have a button of their own, in mm. */
export const blockSizes: readonly Point[] = [
  [30, 30],
  [50, 50],
  [100, 50],
];

/** Sides of a maze's cells that have a button of their own, in mm. */
export const mazeCells: readonly number[] = [100, 150, 200, 300];
