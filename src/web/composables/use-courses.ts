import type { RobotExample } from '#robots/robot';
import { courseName, isUntouched, projectOf, type Course } from '../project/courses';
import type { Previous } from '../project/history';
import { MAIN, type Project } from '../project/project';
import type { App } from './use-app';
import { workName } from './use-file-transfer';

/** Opening courses and coming back to earlier work; neither ever loses what was open. */
export function useCourses(app: App) {
  const { work, notices, dialogs } = app;

  function open(project: Project, name: string, keep: boolean): void {
    work.openProject(project, keep ? workName(app) : null);
    const kept = work.work.value.previous[0];
    if (keep && kept !== undefined) {
      notices.show({
        kind: 'ok',
        key: 'course.keptWork',
        values: { name },
        action: { key: 'course.restore', run: () => restore(kept) },
      });
    } else {
      notices.show({ kind: 'ok', key: 'course.opened', values: { name } });
    }
  }

  const openWhole = (course: Course, keep: boolean): void =>
    open(projectOf(course), courseName(course.scene, course.id), keep);

  /** Puts a sample program into the arena that is open. */
  function openExample(example: RobotExample): void {
    const { project } = work.work.value;
    const title = example.title[app.settings.current.value.language];
    open({ ...project, files: [{ name: MAIN, text: example.source }] }, title, !isUntouched(project));
  }

  /** Opens a course. Where the pupil has written something, they choose whether the course's program comes along. */
  function openCourse(course: Course): void {
    if (isUntouched(work.work.value.project)) {
      openWhole(course, false);
      return;
    }
    dialogs.ask({
      kind: 'choose',
      title: 'course.askTitle',
      text: 'course.askText',
      values: { name: courseName(course.scene, course.id) },
      choices: [
        { key: 'code.cancel', run: () => undefined },
        { key: 'course.sceneOnly', look: 'outline', run: () => work.setScene(course.scene, course.id) },
        { key: 'course.withProgram', look: 'run', run: () => openWhole(course, true) },
      ],
    });
  }

  /** Brings earlier work back; what is open now takes its place among the earlier ones. */
  function restore(entry: Previous): void {
    work.restore(entry, workName(app));
    notices.show({ kind: 'ok', key: 'course.restored' });
  }

  return { openCourse, openExample, restore };
}
