import { defaultProjectSettings, type Project } from '#project/project';
import { NO_ROBOT } from '#simulation/run-setup';

import { leaveProgram } from './programs/own-programs';
import type { Previous } from './storage/history';
import { travelling, withTravelling } from './settings/travelling';
import type { WorkParts, Workplace } from './model/parts';
import { stampSettings } from './stamp-settings';
import { useDevice } from './hardware/use-device';
import { nameWithFile, workName } from './work-name';

/** Functions that replace the present project, and bring an earlier one back. */
export function useOpenings(app: Workplace) {
  const { work, notices } = app;
  const device = useDevice(app);

  /**
   * Opens a project, stopped. The work before it is put aside and can be restored.
   *
   * @param isOurs whether the work before it holds nothing of the pupil's own, and is dropped
   * @param file the file it comes from, without its ending
   */
  function open(project: Project, name: string, isOurs: boolean, file?: string): void {
    if (!isOurs) leave();
    void app.run.reset();
    work.openProject(project, isOurs ? null : workName(app), file);
    work.isBrought = false;
    if (project.settings === undefined) app.settings.bring({ arenaSenses: defaultProjectSettings.arenaSenses });
    else bringSettings(app, project);
    tell(nameWithFile(name, file), isOurs);
  }

  /**
   * Opens an arena, the program stays. An arena of the pupil's own is put aside with the program and can be restored.
   */
  function openScene({ scene, course }: Pick<Project, 'scene' | 'course'>, name: string, isReady: boolean): void {
    const isOurs = isReady && work.work.value.project.task === undefined; // a task goes with its arena
    if (!isOurs) leave();
    device.allowRobot();
    work.setScene(scene, course, isOurs ? null : workName(app));
    device.setUpForCourse();
    tell(name, isOurs);
  }

  /** Leaves the present work with its hardware, and with the program in its course. */
  function leave(): void {
    stampSettings(app);
    leaveProgram(work, Date.now());
  }

  function tell(name: string, isOurs: boolean): void {
    const kept = work.work.value.previous[0];
    if (isOurs || kept === undefined) {
      notices.show({ kind: 'ok', key: 'course.opened', values: { name } });
      return;
    }
    const action = { key: 'course.restore', run: () => restore(kept) } as const;
    notices.show({ kind: 'ok', key: 'course.keptWork', values: { name }, action });
  }

  /** Brings earlier work back; what is open now takes its place among the earlier ones. */
  function restore(entry: Previous): void {
    leave();
    void app.run.reset();
    work.restore(entry, workName(app));
    work.isBrought = false;
    bringSettings(app, entry.project);
    notices.show({ kind: 'ok', key: 'course.restored' });
  }

  return { open, openScene, restore };
}

/** Chooses the hardware of a project, if it names any. The arena disappears with the robot and comes back with it. */
function bringSettings({ settings }: Pick<WorkParts, 'settings'>, { settings: brought }: Project): void {
  if (brought === undefined) return;
  const before = settings.current.value;
  const after = travelling(withTravelling(before, brought));
  const isOther = (after.robot === NO_ROBOT) !== (before.robot === NO_ROBOT);
  settings.bring(isOther ? { ...after, showArena: after.robot !== NO_ROBOT } : after);
}
