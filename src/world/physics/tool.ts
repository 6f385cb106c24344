import type { Body, Fixture } from './planck';
import type { Solid } from './solid';
import type { Surroundings } from './surroundings';

/** Something on a robot that acts by itself, beside being solid. */
export interface Tool {
  /** Before each step of the engine. */
  beforeStep(): void;
  /** After the hand has moved a block or the robot. */
  blockPlaced(): void;
  /** Its solid parts. */
  solids(): readonly Solid[];
}

/** Where a tool is mounted. */
export interface ToolPlace {
  readonly body: Body;
  readonly around: Surroundings;
  /** That this fixture touches the robot from now on is no collision. */
  expectTouch(fixture: Fixture): void;
  /** The tool is gone. */
  drop(tool: Tool): void;
}
