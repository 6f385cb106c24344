import { isProjectLink, projectOfLink } from '#project/link';
import { defaultProjectSettings, type Project } from '#project/project';
import { hasProgram, programOfLink } from '#project/webtigerpython';

import type { App } from '../composables/use-app';
import { isOurs } from '../composables/use-courses';
import { useOpenings } from '../composables/use-openings';
import { say } from '../i18n/say';
import { courses } from '../project/courses';
import { courseName } from '../project/first-course';
import { isSameWork } from '../project/history';
import { linkReason } from './problem-words';
import { presentProject } from './save-work';
import { problemTexts, shareTexts } from './share-texts';

/** The ready courses, as links name them. */
export const readyCourses = (id: string) => courses.find((course) => course.id === id)?.scene ?? null;

/**
 * Opens what an address holds, be it ours or one of WebTigerPython, whole or only its query or fragment.
 *
 * @returns `null` when it is open, else why not: nothing has changed then
 */
export function openAddress(app: App, address: string): string | null {
  const fragment = address.includes('#') ? address.slice(address.indexOf('#')) : address.trim();
  if (isProjectLink(fragment)) return openProjectLink(app, fragment);
  return hasProgram(address) ? openProgramLink(app, address.trim()) : say(problemTexts.notALink);
}

function openProjectLink(app: App, fragment: string): string | null {
  const read = projectOfLink(fragment, readyCourses);
  if ('problem' in read) return linkReason(read.problem);
  const { project, isCourseChanged } = read;
  const { scene, course } = project;
  const name = scene.name === '' && course === null ? say(shareTexts.shared) : courseName(scene, course);
  openProject(app, project, name);
  if (isCourseChanged) {
    const { current } = app.notices;
    const text = say(shareTexts.courseChanged, { name });
    app.notices.show({ ...current.value, kind: 'info', key: 'notice.text', values: { text } });
  }
  return null;
}

/** The program of the link in the arena that is open. */
function openProgramLink(app: App, address: string): string | null {
  const read = programOfLink(address);
  if ('problem' in read) return linkReason(read.problem);
  const { scene, course } = app.work.work.value.project;
  const project: Project = { files: read.files, scene, course };
  openProject(
    app,
    read.device === null ? project : { ...project, settings: { ...defaultProjectSettings, device: read.device } },
    say(shareTexts.sharedProgram),
  );
  return null;
}

/** What is open just like this is not put aside once more. */
function openProject(app: App, project: Project, name: string): void {
  const isOpen = isSameWork(presentProject(app), project);
  useOpenings(app).open(project, name, isOpen || isOurs(app.work.work.value.project));
}
