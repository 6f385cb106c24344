import type { Body, Fixture } from './planck';
import type { Solid } from './solid';
import type { Surroundings } from './surroundings';

/** Something on a robot that acts by itself, besides being solid. */
export interface Tool {
  /** Before each step of the engine. */
  beforeStep(): void;
  /** After the hand tool has moved a block or the robot. */
  blockPlaced(): void;
  /** Its solid parts. */
  solids(): readonly Solid[];
}

/** The robot on which a tool is mounted. */
export interface ToolPlace {
  readonly body: Body;
  readonly around: Surroundings;
  /** Says that a touch of this fixture with the robot is not a collision from now on. */
  expectTouch(fixture: Fixture): void;
  /** The tool was removed. */
  drop(tool: Tool): void;
}
