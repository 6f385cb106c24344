import { isProjectLink, projectOfLink, type ReadyCourses } from '#project/link/link';
import type { Project, SourceFile } from '#project/project';
import { hasProgram, programOfLink } from '#project/webtigerpython/program-link';
import { unread, type Unread } from './unread';

/** Opens the link of a hand-in: a project, or a program of WebTigerPython. */
export function openLink(
  address: string,
  courses: ReadyCourses,
): { readonly project: Project } | { readonly files: readonly SourceFile[] } | { readonly problem: Unread } {
  const fragment = address.slice(Math.max(address.indexOf('#'), 0));
  if (isProjectLink(fragment)) {
    const read = projectOfLink(fragment, courses);
    if (!('problem' in read)) return { project: read.project };
    return unread(read.problem.code === 'newer-version' ? 'newer-link' : 'link');
  }
  if (!hasProgram(address)) return unread('no-work');
  const read = programOfLink(address);
  return 'problem' in read ? unread('link') : { files: read.files };
}
