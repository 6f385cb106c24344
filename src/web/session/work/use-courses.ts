import { filesByName, MAIN, newWork, type Project } from '#project/project';
import { modulesImportedBy } from '#python/imports';
import { AUTO, chooseHardware } from '#simulation/hardware';
import { NO_ROBOT } from '#simulation/run-setup';
import type { Language } from '../../kit/i18n/texts';
import { isBoardProgram, type BoardProgram } from './catalogue/board-programs';
import { projectOf, type Course } from '#catalogue/course';
import { AUTO_DEVICE, boardWish } from './settings/devices';
import { isReadyArena, isUntouched, withExample, type ExampleOf } from './catalogue/examples';
import { courseName } from './catalogue/first-course';
import { isHandedOut, withoutHandedOut } from './model/task-locks';
import type { WorkParts, Workplace } from './model/parts';
import { useDevice } from './hardware/use-device';
import { dateText } from '../../kit/i18n/number-text';
import { t } from '../../kit/i18n';
import {
  isAsOpened,
  leaveProgram,
  noteOpened,
  programsOf,
  withProgram as withOwn,
  type OwnProgram,
} from './programs/own-programs';
import programWords from './programs/words';
import { useOpenings } from './use-openings';

/** Functions that open courses with one of their programs, or with the pupil's own. */
function useWholeCourses(app: Workplace) {
  const openings = useOpenings(app);
  const device = useDevice(app);
  const language = (): Language => app.settings.current.value.language;
  const isNothingOwn = (): boolean => hasNothingOwn(app.work.work.value.project);
  /** Opens a project without the hardware of the previous work, which is chosen separately. */
  function open({ settings: _, ...project }: Project, name: string, ours = isNothingOwn()): void {
    openings.open(project, name, ours);
    app.settings.bring(newWork);
  }

  /** Opens a course with its program, whatever the pupil has written: that is put aside, unless it is known to be `ours`. */
  function openWhole(course: Course, ours?: boolean): void {
    const project = projectOf(course, language());
    noteOpened(project);
    openProject(course, project, ours);
  }

  function openProject(course: Course, project: Project, ours?: boolean): void {
    open(project, courseName(course.scene, course.id), ours);
    const robot = robotOf(project);
    if (robot !== null) device.bringRobot(robot);
    device.setUpForCourse();
  }

  /** Opens a course with one of the pupil's own programs for it; the one it comes with is the other choice. */
  function openOwn(course: Course, own: OwnProgram): void {
    const project = withOwn(projectOf(course, language()), own);
    if (project === null) {
      openWhole(course);
      return;
    }
    openProject(course, project);
    const values = { name: courseName(course.scene, course.id), when: dateText(own.atMs, language()) };
    const action = {
      ...({ key: 'notice.text', values: { text: t(programWords.start) } } as const),
      run: () => openWhole(course),
    };
    app.notices.show({ kind: 'ok', key: 'notice.text', values: { text: t(programWords.isBack, values) }, action });
  }

  /** Opens a course as the pupil has left it, or with its program where they have written nothing in it yet. */
  function openAgain(course: Course): void {
    if (!isNothingOwn()) leaveProgram(app.work, Date.now()); // it may be the same course
    const { last } = programsOf(app.work, course.id);
    if (course.isRandom || last === undefined) openWhole(course);
    else openOwn(course, last);
  }

  /** Opens the arena of a course; the program stays. */
  function openScene(course: Course): void {
    const isReady = !isHandedOut(app.work.work.value.project) && isReadyArena(app.work.scene.value);
    openings.openScene(projectOf(course, language()), courseName(course.scene, course.id), isReady);
    app.settings.bring(newWork);
  }

  return { open, openWhole, openOwn, openAgain, openScene, restore: openings.restore };
}

/** Functions that open courses and earlier work; neither ever loses what was open. */
export function useCourses(app: Workplace) {
  const device = useDevice(app);
  const language = (): Language => app.settings.current.value.language;
  const whole = useWholeCourses(app);
  const { open, openWhole, openAgain, openScene } = whole;

  /** Opens a sample program with its robot and what it needs on it, in the arena it is made for: see `withExample`. */
  function openExample(entry: ExampleOf): void {
    const { example, robot } = entry;
    open(alone(withExample(app.work.work.value.project, entry, language())), example.title[language()]);
    device.bringRobot(robot, example.options);
  }

  /** Opens a sample program for the microcomputer alone: the robot goes, and with it the arena. */
  function openBoardProgram({ title, source, board }: BoardProgram): void {
    void app.run.reset();
    open(alone(withProgram(app, source[language()])), title[language()]);
    const wish = boardWish(app.settings.current.value.device);
    if (board !== null && wish !== board && wish !== AUTO) device.chooseDevice(AUTO_DEVICE);
    device.chooseRobot(NO_ROBOT);
  }

  /**
   * Opens a course. Where the pupil has written something, they choose whether the course's program comes along: one of
   * their own if they have one, else the one that it comes with.
   *
   * @param anew in any case the one that it comes with
   */
  function openCourse(course: Course, anew = false): void {
    const openIt = anew ? openWhole : openAgain;
    if (isOurProgram(app.work.work.value.project)) {
      openIt(course);
      return;
    }
    app.dialogs.ask({
      kind: 'choose',
      title: 'course.askTitle',
      text: 'course.askText',
      values: { name: courseName(course.scene, course.id) },
      choices: [
        { key: 'code.cancel', run: () => undefined },
        { key: 'course.sceneOnly', look: 'outline', run: () => openScene(course) },
        { key: 'course.withProgram', look: 'run', run: () => openIt(course) },
      ],
    });
  }

  return { ...whole, openCourse, openExample, openBoardProgram };
}

/** The project with its first device only, and without a task that was handed out. */
const alone = ({ devices: _, ...project }: Project): Project => withoutHandedOut(project);

/** The robot that a course and its program are made for; `null`: none. */
function robotOf({ scene, files }: Project) {
  const hardware = chooseHardware({ scene, imports: modulesImportedBy(filesByName(files)), robot: AUTO, board: AUTO });
  return 'problem' in hardware ? null : hardware.robot;
}

/** The open project, with this program as its only file. */
const withProgram = ({ work }: Pick<WorkParts, 'work'>, source: string): Project => ({
  ...work.work.value.project,
  files: [{ name: MAIN, text: source }],
});

/** True if nothing of the pupil's own is in a project: not in the files, not in the arena; and no task was set for them. */
export const hasNothingOwn = (project: Project): boolean =>
  project.task === undefined && isOurProgram(project) && isReadyArena(project.scene);

/** True if nothing of the pupil's own is in the files. */
const isOurProgram = (project: Project): boolean =>
  isUntouched(project) ||
  isAsOpened(project) ||
  (project.devices === undefined && project.files.length === 1 && isBoardProgram(project.files[0]?.text ?? ''));
