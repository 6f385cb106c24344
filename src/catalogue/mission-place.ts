/** The robots that have a ladder of missions, in the order in which they are offered. */
export const missionRobots = ['maqueen-lite', 'maqueen-plus-v2', 'maqueen-plus-v3', 'callibot'] as const;
export type MissionRobot = (typeof missionRobots)[number];

/** Number of missions on each ladder. */
export const LADDER = 12;

/** The place of a course on the ladder of missions. */
export interface Mission {
  /** Name of its folder without the number; the same for each robot. */
  readonly name: string;
  /** From 1 on. */
  readonly number: number;
  readonly robot: MissionRobot;
  /** The piece of Python that it brings, empty where it brings nothing new. */
  readonly news: string;
}

/** Id of a mission for one robot in projects and links. */
export const missionId = (name: string, robot: MissionRobot): string => `${name}-${robot}`;
