import { boardOf } from '#board/boards/board-of-device';
import { documentOfAddress } from '#intake/address';
import { unreadText } from '#check/report/say';
import type { HexBoard } from '#hex/firmware';
import type { AddressDocument, Document, HexDocument } from '#intake/document';
import { documentOfText, TOURNAMENT } from '#intake/text';
import { isProjectLink } from '#project/link/link';
import { runFilesOf } from '#project/devices';
import { filesByName, newWork, type Project, type ProjectSettings } from '#project/project';
import { noteText } from '#project/webtigerpython/say';
import type { Scene } from '#scene/scene';
import type { FurtherWish } from '#simulation/hardware';

/** The work to run: a program alone, or a project with everything that belongs to it. */
export interface Work {
  readonly files: Readonly<Record<string, string>>;
  /** `null`: the work has no course. */
  readonly scene: Scene | null;
  readonly settings: Partial<ProjectSettings>;
  /** Name of its first device; `null`: it has only one. */
  readonly firstName: string | null;
  /** The devices after the first. */
  readonly devices: readonly DeviceWork[];
  /** Sentences on what of a link could not be taken over, or was changed. */
  readonly notes: readonly string[];
}

/** A device after the first, as a project has it. */
export interface DeviceWork extends Pick<FurtherWish, 'robot' | 'board' | 'robotOptions'> {
  readonly name: string;
  readonly files: Readonly<Record<string, string>>;
  readonly firmware: string;
}

/** A program alone. */
export const onlyProgram = (files: Work['files'], settings: Work['settings']): Work => ({
  ...{ files, settings },
  ...{ scene: null, firstName: null, devices: [], notes: [] },
});

type Read = Work | { readonly problem: string };

/** True if the words on the command line are an address rather than the name of a file. */
export const isAddress = (text: string): boolean => /^https?:\/\//i.test(text) || isProjectLink(text);

/** A word of the command line as problems name it: an address may be as long as a program. */
export const shortened = (word: string): string => (word.length > 60 ? `${word.slice(0, 57)}…` : word);

/** The content of an address. */
export async function documentAt(address: string): Promise<AddressDocument> {
  const { readyCourse } = await import('./ready-courses');
  return documentOfAddress(address, readyCourse);
}

/** Why the content of an address is not what is wanted: neither a project nor a program. */
export function addressProblem(document: AddressDocument): string {
  if (document.kind === 'recording') return RECORDED;
  return document.kind === 'unreadable' && document.link !== undefined
    ? `The link cannot be opened. ${withoutReload(document.message)}`
    : 'The address holds neither a project nor a program. Copy the whole link.';
}

/** A project in a link, or a program in a link of WebTigerPython, perhaps with its world. */
export async function workOfAddress(address: string): Promise<Read> {
  const document = await documentAt(address);
  if (document.kind === 'project') return workOfProject(document.project);
  if (document.kind === 'course') return { problem: COURSE_ALONE };
  if (document.kind !== 'program') return { problem: addressProblem(document) };
  const { files, scene, device, notes } = document;
  const work = onlyProgram(filesByName(files), device === null ? {} : { device });
  return { ...work, scene, notes: notes.map((note) => noteText(note, 'en')) };
}

const COURSE_ALONE = 'is a course without a program. Give it with --scene, and name a program.';
const RECORDED = 'is a recorded run. Run it again with parcours replay.';

/** The program in a board's file. */
export function workOfHex(document: Document): Read {
  if (document.kind === 'unreadable') return { problem: unreadText(document.problem, 'en') };
  if (document.kind !== 'hex') return { problem: 'is no hex.' };
  const { files, boards } = document;
  return { ...onlyProgram(filesByName(files), { ...newWork, ...deviceOf(boards) }), notes: hexNotes(document) };
}

/** A Calliope mini says so; of a micro:bit the program's imports say more. */
export const deviceOf = (boards: readonly HexBoard[]): { readonly device?: string } =>
  boards.some((board) => board.startsWith('calliope')) ? { device: 'calliope-mini-3' } : {};

/** Sentences on files of a hex that are not among those of the work. */
export const hexNotes = ({ ours, unfit }: Pick<HexDocument, 'ours' | 'unfit'>): readonly string[] => [
  ...(ours.length === 0 ? [] : [`${ours.join(', ')}: left out, since Parcours brings it along.`]),
  ...(unfit.length === 0 ? [] : [`${unfit.join(', ')}: left out, since a project holds only texts with simple names.`]),
];

/** A project from the text of its file. */
export function workOfJson(text: string): Read {
  const document = documentOfText(text, () => null);
  switch (document.kind) {
    case 'project':
      return workOfProject(document.project);
    case 'course':
      return { problem: COURSE_ALONE };
    case 'series':
      return { problem: 'is a series of tasks. Open it on the page, or name one of them for parcours check.' };
    case 'recording':
      return { problem: RECORDED };
    case 'tournament':
      return { problem: TOURNAMENT.message };
    case 'unreadable':
      return { problem: document.problems.map(({ message }) => message).join('\n') };
  }
}

function workOfProject(project: Project): Work {
  const { scene, settings = {}, devices } = project;
  const others = (devices?.others ?? []).map(({ name, device, firmware, robot, robotOptions }, index) => {
    const files = runFilesOf(project, index + 1);
    return { name, files, firmware, robot, board: boardOf(device), robotOptions };
  });
  return {
    files: runFilesOf(project, 0),
    scene,
    settings,
    firstName: devices?.first ?? null,
    devices: others,
    notes: [],
  };
}

/** The advice to reload is for people with the page open. */
const withoutReload = (message: string): string =>
  message.replace(' Reload the page to update.', ' Update Parcours, or save the project as a file on the page.');
