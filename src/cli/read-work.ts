import { hasProgram, programOfLink } from '#project/webtigerpython/program-link';
import { isProjectLink, projectOfLink } from '#project/link/link';
import { boardOf } from '#board/boards/board-of-device';
import { openJson } from '#project/open-json';
import { runFilesOf } from '#project/devices';
import { filesByName, type Project, type ProjectSettings, type SourceFile } from '#project/project';
import type { Scene } from '#scene/scene';
import type { FurtherWish } from '#simulation/hardware';
import { isTapeFile } from '#tape/tape';

/** What stands in the place of a program: a program alone, or a project with what belongs to it. */
export interface Work {
  readonly files: Readonly<Record<string, string>>;
  /** `null`: the work has no course. */
  readonly scene: Scene | null;
  readonly settings: Partial<ProjectSettings>;
  /** Name of its first device; `null`: it has only one. */
  readonly firstName: string | null;
  /** The devices after the first. */
  readonly devices: readonly DeviceWork[];
}

/** A device after the first, as a project has it. */
export interface DeviceWork extends Pick<FurtherWish, 'robot' | 'board' | 'robotOptions'> {
  readonly name: string;
  readonly files: Readonly<Record<string, string>>;
  readonly firmware: string;
}

/** A program alone. */
export const onlyProgram = (files: Work['files']): Work => ({
  files,
  ...{ scene: null, settings: {}, firstName: null, devices: [] },
});

type Read = Work | { readonly problem: string };

/** Whether the words on the command line are an address rather than the name of a file. */
export const isAddress = (text: string): boolean => /^https?:\/\//i.test(text) || isProjectLink(text);

/** What was opened: a project, a program alone with the microcomputer that it names, or why nothing. */
export type OpenedWork =
  | { readonly project: Project }
  | { readonly files: readonly SourceFile[]; readonly device: string | null }
  | { readonly problem: string };

/** Opens a project in a link, or a program in a link of WebTigerPython. */
export async function openAddress(address: string): Promise<OpenedWork> {
  const fragment = address.slice(Math.max(address.indexOf('#'), 0));
  if (isProjectLink(fragment)) {
    const { readyCourse } = await import('./ready-courses');
    const read = projectOfLink(fragment, readyCourse);
    if ('problem' in read) return { problem: `The link cannot be opened. ${withoutReload(read.problem.message)}` };
    return { project: read.project };
  }
  if (!hasProgram(address))
    return { problem: 'The address holds neither a project nor a program. Copy the whole link.' };
  const read = programOfLink(address);
  return 'problem' in read ? { problem: `The link cannot be opened. ${read.problem.message}` } : read;
}

/** A project in a link, or a program in a link of WebTigerPython. */
export async function workOfAddress(address: string): Promise<Read> {
  const opened = await openAddress(address);
  if ('problem' in opened) return opened;
  if ('project' in opened) return workOfProject(opened.project);
  const program = onlyProgram(filesByName(opened.files));
  return opened.device === null ? program : { ...program, settings: { device: opened.device } };
}

/** A project from the text of its file. */
export function workOfJson(text: string): Read {
  if (isTapeFile(text)) return { problem: 'is a recorded run. Run it again with parcours replay.' };
  const opened = openJson(text);
  if (opened.kind === 'problem') return { problem: opened.problems.map(({ message }) => message).join('\n') };
  if (opened.kind === 'scene')
    return { problem: 'is a course without a program. Give it with --scene, and name a program.' };
  return workOfProject(opened.project);
}

function workOfProject(project: Project): Work {
  const { scene, settings = {}, devices } = project;
  const others = (devices?.others ?? []).map(({ name, device, firmware, robot, robotOptions }, index) => {
    const files = runFilesOf(project, index + 1);
    return { name, files, firmware, robot, board: boardOf(device), robotOptions };
  });
  return { files: runFilesOf(project, 0), scene, settings, firstName: devices?.first ?? null, devices: others };
}

/** The page says so to people who have it open. */
const withoutReload = (message: string): string =>
  message.replace(' Reload the page to update.', ' Update Parcours, or save the project as a file on the page.');
