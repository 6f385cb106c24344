import { isProjectLink, projectOfLink, type ReadyCourses } from '#project/link/link';
import type { Project, SourceFile } from '#project/project';
import { isRunLink, readRunLink } from '#tape/link';
import { hasProgram, programOfLink } from '#project/webtigerpython/program-link';
import { handedRun } from './handed-run';
import { unread, type Unread } from '#check/hand-in/unread';

/** Opens the link of a hand-in: a project, a run, or a program of WebTigerPython. */
export function openLink(
  address: string,
  courses: ReadyCourses,
):
  | { readonly project: Project; readonly isEdited?: boolean }
  | { readonly files: readonly SourceFile[] }
  | { readonly problem: Unread } {
  const fragment = address.slice(Math.max(address.indexOf('#'), 0));
  if (isProjectLink(fragment)) {
    const read = projectOfLink(fragment, courses);
    if (!('problem' in read)) return { project: read.project };
    return unread(read.problem.code === 'newer-version' ? 'newer-link' : 'link');
  }
  if (isRunLink(fragment)) {
    const read = readRunLink(fragment);
    if ('fault' in read) return unread(read.fault === 'newer' ? 'newer-link' : 'link');
    const run = handedRun(read.text);
    return 'detail' in run ? unread(run.isNewer ? 'newer-link' : 'link') : run;
  }
  if (!hasProgram(address)) return unread('no-work');
  const read = programOfLink(address);
  return 'problem' in read ? unread('link') : { files: read.files };
}
