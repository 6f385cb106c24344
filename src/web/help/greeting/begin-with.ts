import type { LayoutParts } from '../../session/layout/parts';
import { chooseStage } from '../../session/layout/stages/choose-stage';
import type { ModeParts } from '../../session/mode/parts';
import type { TaskParts } from '../../session/task/parts';
import { firstCourse } from '../../session/work/catalogue/first-course';
import type { Workplace } from '../../session/work/model/parts';
import type { Course } from '#catalogue/course';
import { missionRobots } from '#catalogue/mission-place';

type Parts = Workplace & Pick<LayoutParts, 'layout'> & TaskParts;

/** Begins to learn driving: with the first mission that was not passed yet. The work that is open is put aside. */
export async function beginDriving(app: Parts): Promise<void> {
  await chooseStage(app, 'robot');
  const mission = await nextMission(app);
  if (mission === null || mission.id === app.work.work.value.project.course) app.task.present();
  else {
    const { useCourses } = await import('../../session/work/use-courses');
    useCourses(app).openAgain(mission);
  }
}

/** The first mission without stars, for the robot of the open one, else for the first robot; without a connection the first of all. */
async function nextMission({ task }: Parts): Promise<Course | null> {
  try {
    const { ladderOf } = await import('#catalogue/missions');
    const ladder = ladderOf(task.ready.value?.mission?.robot ?? missionRobots[0]);
    return ladder.find(({ id }) => !(id in task.stars.all.value)) ?? ladder[0] ?? null;
  } catch {
    return firstCourse ?? null;
  }
}

/** Begins with a program for the microcomputer alone. */
export const beginWithBoard = (app: Parts): Promise<void> => chooseStage(app, 'board');

/** Begins to build: opens an empty floor with the tools. The program stays. */
export async function beginBuilding(app: Parts & ModeParts): Promise<void> {
  await chooseStage(app, 'all');
  try {
    const [{ readyCourse }, { useCourses }] = await Promise.all([
      import('../../session/work/catalogue/ready-courses'),
      import('../../session/work/use-courses'),
    ]);
    const empty = readyCourse('empty');
    if (empty !== null) useCourses(app).openScene(empty);
  } catch {
    // Without a connection the first course stays: it can be drawn on as well.
  }
  app.mode.enter('build');
}
