import { isProjectLink, projectOfLink } from '#project/link/link';
import { defaultProjectSettings, type Project } from '#project/project';
import { hasProgram, programOfLink } from '#project/webtigerpython/program-link';

import { isRunLink } from '#tape/link';

import type { Workplace } from '../work/model/parts';
import { isOurs, useCourses } from '../work/use-courses';
import { useDevice } from '../work/hardware/use-device';
import { useOpenings } from '../work/use-openings';
import { parametersOf, urlOf } from '../visit/address';
import { say } from '../page/i18n/say';
import type { Course } from '#catalogue/course';
import { readyCourse, readyScene } from '../work/catalogue/ready-courses';
import { courseName } from '../work/catalogue/first-course';
import { isSameWork } from '../work/storage/history';
import { openRunLink } from './open-run';
import { linkReason } from './problem-words';
import { presentProject } from './save-work';
import { shareWords as words } from './share-words';

/**
 * Opens the content of an address, ours or one of WebTigerPython, whole or only its query or fragment: a project, a run, a
 * ready course (`task`: with its program, `world`: the arena alone), a program, or a program in a course. Never runs
 * it; a recorded run alone is repeated, silently, before it is looked at.
 *
 * @param wish as `held`, the other settings in the address hold for this visit; otherwise a program brings its
 *   microcomputer along
 * @returns `null` on success, otherwise why it failed; then nothing has changed
 */
export function openAddress(app: Workplace, address: string, wish: 'held' | 'brought' = 'brought'): string | null {
  const fragment = address.includes('#') ? address.slice(address.indexOf('#')) : address.trim();
  if (isProjectLink(fragment)) return openProjectLink(app, fragment);
  if (isRunLink(fragment)) return openRunLink(app, fragment);
  if (showSeries(address.trim(), fragment)) return null;
  const id = courseIn(address.trim());
  const course = id === null ? null : readyCourse(id.course);
  if (id !== null && course === null) return say(words.problems.unknownCourse, { course: id.course });
  if (hasProgram(address)) return openProgramLink(app, address.trim(), course, wish);
  if (id === null || course === null) return say(words.problems.notALink);
  const { openScene, openWhole } = useCourses(app);
  if (id.name === 'task') openWhole(course);
  else openScene(course);
  return null;
}

/** A series has an address of this page, which shows it; a relative one is seen from the page that it was given with. */
function showSeries(address: string, fragment: string): boolean {
  const [, inside, place] = /^#?(?:(s=\d.*)|series=(.+))$/.exec(fragment) ?? [];
  if (inside !== undefined) location.hash = inside;
  else if (place !== undefined) {
    const base = urlOf(address.replace(/#.*/, ''), location.href) ?? location.href;
    location.hash = `series=${urlOf(decodeURIComponent(place), String(base))?.href ?? place}`;
  }
  return (inside ?? place) !== undefined;
}

/** The ready course that an address names. */
function courseIn(address: string): { readonly name: 'task' | 'world'; readonly course: string } | null {
  const url = urlOf(address, location.href);
  if (url === null) return null;
  const given = parametersOf(url);
  const name = given.has('task') ? 'task' : 'world';
  const course = given.get(name);
  return course === null ? null : { name, course };
}

function openProjectLink(app: Workplace, fragment: string): string | null {
  const read = projectOfLink(fragment, readyScene);
  if ('problem' in read) return linkReason(read.problem);
  const { project, isCourseChanged } = read;
  const { scene, course } = project;
  const name = scene.name === '' && course === null ? say(words.shared) : courseName(scene, course);
  openProject(app, project, name);
  if (isCourseChanged) {
    const { current } = app.notices;
    const text = say(words.courseChanged, { name });
    app.notices.show({ ...current.value, kind: 'info', key: 'notice.text', values: { text } });
  }
  return null;
}

/** The program of the link in the course it names, else in the arena that is open. */
function openProgramLink(
  app: Workplace,
  address: string,
  course: Course | null,
  wish: 'held' | 'brought',
): string | null {
  const read = programOfLink(address);
  if ('problem' in read) return linkReason(read.problem);
  const { files, device } = read;
  const open = app.work.work.value.project;
  const project: Project =
    course === null
      ? { files, scene: open.scene, course: open.course }
      : { files, scene: course.scene, course: course.id };
  const settings = { ...defaultProjectSettings, device: device ?? defaultProjectSettings.device };
  const brings = device !== null && wish === 'brought';
  openProject(app, brings ? { ...project, settings } : project, say(words.sharedProgram));
  if (course !== null) {
    const { allowRobot, setUpForCourse } = useDevice(app);
    allowRobot();
    setUpForCourse();
  }
  return null;
}

/** Work that is already open exactly like this is not put aside again. */
function openProject(app: Workplace, project: Project, name: string): void {
  const isOpen = isSameWork(presentProject(app), project);
  useOpenings(app).open(project, name, isOpen || isOurs(app.work.work.value.project));
}
