import type { Unread } from '#check/hand-in/unread';
import type { SeriesProblem } from '#check/series/read-series';
import type { Series } from '#check/series/series';
import type { LinkProblem } from '#project/link/link';
import type { Project, SourceFile } from '#project/project';
import type { ProjectProblem } from '#project/problem';
import type { RewrittenLine as Rewritten } from '#advice/repeat';
import type { Note } from '#project/webtigerpython/note';
import type { ProgramLinkProblem } from '#project/webtigerpython/program-link';
import type { Scene } from '#scene/scene';
import type { MapNote } from '#rescue-line/notes';
import type { SceneProblem } from '#scene/problem';
import type { HexBoard } from '#hex/firmware';
import type { Decoded } from './decode';
import type { NamedLink } from './links';
import type { TreeFile } from './tree';

/**
 * The result of reading a file, a text or an address. Each door takes some of the kinds and refuses the others in
 * words.
 */
export type Document =
  | ProgramDocument
  | HexDocument
  | ProjectDocument
  | CourseDocument
  | SeriesDocument
  | RecordingDocument
  | TournamentDocument
  /** A zip: hand-ins, tasks, or the folder of a series lie in it. Or the files of an e-mail, whose sender is `from`. */
  | { readonly kind: 'zip'; readonly files: readonly TreeFile[]; readonly from?: string }
  /** A text with links to hand-ins. */
  | { readonly kind: 'links'; readonly links: readonly NamedLink[] }
  /** A device's readings, to be read by `#device-log`. */
  | { readonly kind: 'log'; readonly bytes: Uint8Array }
  | { readonly kind: 'picture' }
  | Unreadable;

/** A text of JSON. */
export type TextDocument =
  ProjectDocument | CourseDocument | SeriesDocument | RecordingDocument | TournamentDocument | Unreadable;

/** The content of an address. */
export type AddressDocument =
  | ProgramDocument
  | ProjectDocument
  | CourseDocument
  | RecordingDocument
  /** The link of a series, from `s=` on; `seriesOfLink` reads it. */
  | { readonly kind: 'series-link'; readonly link: string }
  /** The file of a series on a web server, seen from the page of the address. */
  | { readonly kind: 'series-place'; readonly place: string }
  | ReadyDocument
  | Unreadable;

/** A program, perhaps with the world of a link of WebTigerPython. */
export interface ProgramDocument {
  readonly kind: 'program';
  /** main.py first in an address; in a file the one program, under the file's name. */
  readonly files: readonly SourceFile[];
  /** The coding of the file's text; left out: UTF-8. */
  readonly coding?: Decoded['coding'];
  /** Id of the microcomputer it is for; `null`: not said. */
  readonly device: string | null;
  /** Id of the ready course that the address also names; `null`: none. */
  readonly course: string | null;
  /** The course of its link; `null`: none. */
  readonly scene: Scene | null;
  /** Tell of everything in a link that could not be taken over, or was changed. */
  readonly notes: readonly Note[];
  /** Lines that were written in Python: `files` has them as they are now. */
  readonly rewritten: readonly RewrittenLine[];
}

/** The program in a board's file. */
export interface HexDocument {
  readonly kind: 'hex';
  /** main.py first; at least one file. */
  readonly files: readonly SourceFile[];
  /** The boards that it is for: a universal one has two. */
  readonly boards: readonly HexBoard[];
  /** Names of modules in it that are here anyway: they are not among its files. */
  readonly ours: readonly string[];
  /** Names of what a project cannot hold, such as sounds. */
  readonly unfit: readonly string[];
}

/** A line of a file that was written otherwise. */
export interface RewrittenLine extends Rewritten {
  readonly file: string;
}

/** A ready course. */
export interface ReadyDocument {
  readonly kind: 'ready';
  /** Its id; there may be no such course. */
  readonly course: string;
  /** True if it is opened with its program. */
  readonly isWhole: boolean;
}

export interface ProjectDocument {
  readonly kind: 'project';
  readonly project: Project;
  /** The ready course that its link names has changed since the link was made. */
  readonly isCourseChanged: boolean;
}

export interface CourseDocument {
  readonly kind: 'course';
  readonly scene: Scene;
  /** Id of the microcomputer that its link names; `null`: not said. */
  readonly device: string | null;
  /** A world of WebTigerPython: from its link, or from its course file. */
  readonly isFromWebTigerPython: boolean;
  /** Tell of everything in a world of WebTigerPython that could not be taken over, or was changed. */
  readonly notes: readonly Note[];
  /** Tell of everything in a map of a rescue line that is not in its course. */
  readonly mapNotes: readonly MapNote[];
}

/** A series; tasks in files beside it are not read yet (`readTasks`). */
export interface SeriesDocument {
  readonly kind: 'series';
  readonly series: Series;
}

/** A recorded run, to be read by `#tape/file`. */
export interface RecordingDocument {
  readonly kind: 'recording';
  readonly text: string;
  /** The moment that is shown first, in simulated µs. */
  readonly atUs: number;
}

/** A tournament that was played, to be read by `#lab/tournament/file`. */
export interface TournamentDocument {
  readonly kind: 'tournament';
  readonly text: string;
}

/** One thing that is wrong inside a file. */
export type FileProblem = ProjectProblem | SceneProblem | SeriesProblem;

/** Something that cannot be read, and why. */
export interface Unreadable {
  readonly kind: 'unreadable';
  /** By code and parameters, as reports have it. */
  readonly problem: Unread;
  /** In English, for the command line: the first thing that is wrong inside, and how many follow. Empty: the code says all. */
  readonly message: string;
  /** All that is wrong inside a file. */
  readonly problems: readonly FileProblem[];
  /** The fault of a link. */
  readonly link?: LinkProblem | ProgramLinkProblem;
  /** The fault of the link of a series. */
  readonly seriesLink?: 'damaged' | 'newer' | 'too-large';
}

/** Something unreadable of which the code says all. */
export const unreadable = (problem: Unread): Unreadable => ({
  ...{ kind: 'unreadable', problem, message: '', problems: [] },
});
