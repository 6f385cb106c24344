import { hasProgram, programOfLink } from '#project/webtigerpython/program-link';
import { isProjectLink, projectOfLink } from '#project/link/link';
import { openJson } from '#project/open-json';
import { filesByName, type ProjectSettings } from '#project/project';
import type { Scene } from '#scene/scene';

/** What stands in the place of a program: a program alone, or a project with what belongs to it. */
export interface Work {
  readonly files: Readonly<Record<string, string>>;
  /** `null`: the work has no course. */
  readonly scene: Scene | null;
  readonly settings: Partial<ProjectSettings>;
}

type Read = Work | { readonly problem: string };

/** Whether the words on the command line are an address rather than the name of a file. */
export const isAddress = (text: string): boolean => /^https?:\/\//i.test(text) || isProjectLink(text);

/** A project in a link, or a program in a link of WebTigerPython. */
export async function workOfAddress(address: string): Promise<Read> {
  const fragment = address.slice(Math.max(address.indexOf('#'), 0));
  if (isProjectLink(fragment)) {
    const { readyCourse } = await import('./ready-courses');
    const read = projectOfLink(fragment, readyCourse);
    if ('problem' in read) return { problem: `The link cannot be opened. ${withoutReload(read.problem.message)}` };
    const { files, scene, settings = {} } = read.project;
    return { files: filesByName(files), scene, settings };
  }
  if (!hasProgram(address))
    return { problem: 'The address holds neither a project nor a program. Copy the whole link.' };
  const read = programOfLink(address);
  if ('problem' in read) return { problem: `The link cannot be opened. ${read.problem.message}` };
  return { files: filesByName(read.files), scene: null, settings: read.device === null ? {} : { device: read.device } };
}

/** A project from the text of its file. */
export function workOfJson(text: string): Read {
  const opened = openJson(text);
  if (opened.kind === 'problem') return { problem: opened.problems.map(({ message }) => message).join('\n') };
  if (opened.kind === 'scene')
    return { problem: 'is a course without a program. Give it with --scene, and name a program.' };
  const { files, scene, settings = {} } = opened.project;
  return { files: filesByName(files), scene, settings };
}

/** The page says so to people who have it open. */
const withoutReload = (message: string): string =>
  message.replace(' Reload the page to update.', ' Update Parcours, or save the project as a file on the page.');
