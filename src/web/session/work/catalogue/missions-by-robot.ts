import type { MissionCourse } from '#catalogue/mission';
import { missionRobots } from '#catalogue/mission-place';
import { missions } from '#catalogue/missions';
import { robotTypes } from '#robots/index';

/** The missions of each robot, under its name: those of all robots are called alike. */
export const missionsByRobot: readonly { readonly robot: string; readonly missions: readonly MissionCourse[] }[] =
  missionRobots.map((id) => ({
    robot: robotTypes.find((type) => type.id === id)?.name ?? id,
    missions: missions.filter(({ mission }) => mission.robot === id),
  }));
