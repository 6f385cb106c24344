import { hasFeedback } from '#check/feedback/has-feedback';
import { documentOfAddress } from '#intake/address';
import { documentOfText } from '#intake/text';
import type { CourseDocument, ProgramDocument, ProjectDocument, ReadyDocument } from '#intake/document';
import { defaultProjectSettings, type Project } from '#project/project';

import type { Workplace } from '../../session/work/model/parts';
import { bringTo } from '../../session/layout/brought-file';
import { hasNothingOwn, useCourses } from '../../session/work/use-courses';
import { useDevice } from '../../session/work/hardware/use-device';
import { AUTO_ROBOT } from '../../session/work/settings/devices';
import { useOpenings } from '../../session/work/use-openings';
import { urlOf } from '../../session/visit/address';
import { t } from '../../kit/i18n';
import { readyCourse, readyScene } from '../../session/work/catalogue/ready-courses';
import { isReadyArena } from '../../session/work/catalogue/examples';
import { courseName } from '../../session/work/catalogue/first-course';
import { isSameWork } from '../../session/work/storage/history';
import { elsewhereOf } from '../elsewhere/parts';
import { tellOfCourse } from '../elsewhere/tell-of-course';
import { lookAtFeedback, openRun } from './open-run';
import { linkReason, reasonOf } from './problem-words';
import { presentProject } from '../../session/work/save-work';
import words from './words';

/**
 * Opens the content of an address, ours or one of WebTigerPython, whole or only its query or fragment: a project, a run, a
 * ready course (`task`: with its program, `world`: the arena alone), a course, a program, or a program in a course; or that of
 * a file that was pasted as text. Never runs it; a recorded run alone is repeated, silently, before it is looked at.
 *
 * @param wish `held`: the other settings in the address hold for this visit; `brought`: a program brings its
 *   microcomputer along
 * @returns `null` on success, otherwise why it failed; then nothing has changed
 */
export function openAddress(app: Workplace, address: string, wish: 'held' | 'brought' = 'brought'): string | null {
  const isFile = address.trimStart().startsWith('{');
  const document = isFile ? documentOfText(address, readyScene) : documentOfAddress(address, readyScene);
  switch (document.kind) {
    case 'project':
      return openLinked(app, document);
    case 'recording':
      return openRun(app, { ...document, file: t(words.openField) });
    case 'program':
      return openProgram(app, document, wish);
    case 'course':
      return openCourse(app, document, !isFile);
    case 'ready':
      return openReady(app, document);
    // A series has an address of this page, which shows it.
    case 'series-link':
      location.hash = document.link;
      return null;
    case 'series-place':
      location.hash = `series=${placeSeenFrom(address.trim(), document.place)}`;
      return null;
    case 'tournament':
      bringTo(app, 'tournament', document.text);
      return null;
    case 'series':
      return t(words.problems.notALink);
    case 'unreadable':
      if (document.link !== undefined) return linkReason(document.link);
      return document.problems.length > 0 ? reasonOf(document.problems) : t(words.problems.notALink);
  }
}

/** A relative place of a series is seen from the page that it was given with. */
function placeSeenFrom(address: string, place: string): string {
  const base = urlOf(address.replace(/#.*/, ''), location.href) ?? location.href;
  return urlOf(decodeURIComponent(place), String(base))?.href ?? place;
}

/** The program stays. */
function openCourse(app: Workplace, document: CourseDocument, isLink: boolean): null {
  const { scene } = document;
  useOpenings(app).openScene({ scene, course: null }, t(words.shared), isReadyArena(app.work.scene.value));
  tellOfCourse(app, document, isLink);
  return null;
}

function openReady(app: Workplace, { course: id, isWhole }: ReadyDocument): string | null {
  const course = readyCourse(id);
  if (course === null) return t(words.problems.unknownCourse, { course: id });
  const { openScene, openWhole } = useCourses(app);
  if (isWhole) openWhole(course);
  else openScene(course);
  return null;
}

function openLinked(app: Workplace, { project, isCourseChanged }: ProjectDocument): string | null {
  const { scene, course } = project;
  const name = scene.name === '' && course === null ? t(words.shared) : courseName(scene, course);
  openProject(app, project, name);
  if (isCourseChanged) {
    const { current } = app.notices;
    const text = t(words.courseChanged, { name });
    app.notices.show({ ...current.value, kind: 'info', key: 'notice.text', values: { text } });
  }
  if (hasFeedback(project)) void lookAtFeedback(app, name);
  return null;
}

/** The program of a link in the course it names, else in its own, else in the arena that is open. */
function openProgram(app: Workplace, document: ProgramDocument, wish: 'held' | 'brought'): string | null {
  const { device, course: id, scene } = document;
  const files = document.files.map(({ name, text }) => ({ name, text: text.replaceAll('\r\n', '\n') }));
  const course = id === null ? null : readyCourse(id);
  if (id !== null && course === null) return t(words.problems.unknownCourse, { course: id });
  const open = app.work.work.value.project;
  const project: Project =
    course !== null
      ? { files, scene: course.scene, course: course.id }
      : scene !== null
        ? { files, scene, course: null }
        : { files, scene: open.scene, course: open.course };
  const settings = { ...defaultProjectSettings, device: device ?? defaultProjectSettings.device };
  const brings = device !== null && wish === 'brought';
  openProject(app, brings ? { ...project, settings } : project, t(words.sharedProgram));
  if (course !== null || scene !== null) {
    const { allowRobot, setUpForCourse } = useDevice(app);
    allowRobot();
    // In a world of WebTigerPython the program's imports say which robot drives.
    if (scene !== null) app.settings.bring({ robot: AUTO_ROBOT });
    setUpForCourse();
  }
  elsewhereOf(app).brought.tell({ ...document, files, scene: project.scene === scene ? scene : null, isLink: true });
  return null;
}

/** Work that is already open exactly like this is not put aside again. */
function openProject(app: Workplace, project: Project, name: string): void {
  const isOpen = isSameWork(presentProject(app), project);
  useOpenings(app).open(project, name, isOpen || hasNothingOwn(app.work.work.value.project));
}
