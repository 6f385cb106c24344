import type { CourseEditorParts } from '../../course/editor/state/parts';
import type { LayoutParts } from '../../session/layout/parts';
import type { TaskParts } from '../../session/task/parts';
import type { Workplace } from '../../session/work/model/parts';
import { chooseStage } from '../../session/layout/stages/choose-stage';
import type { Stage } from '../../session/layout/stages/stage';

type Parts = Workplace & Pick<LayoutParts, 'layout'> & TaskParts & Pick<CourseEditorParts, 'editor'>;

/** Answers the greeting with a stage, and opens something to begin with: the task, or an empty floor. */
export async function beginWith(app: Parts, stage: Stage): Promise<void> {
  await chooseStage(app, stage);
  if (stage === 'robot') app.task.open();
  if (stage === 'all') await openFloor(app);
}

/** Opens an empty floor, with the pen in hand. The program stays. */
async function openFloor(app: Parts): Promise<void> {
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
  app.task.close();
  app.editor.choose('pen');
}
