/** Why a file could not be opened, read or written, in plain words. */
export function reasonOf(error: unknown): string {
  const code = error instanceof Error && 'code' in error ? error.code : undefined;
  switch (code) {
    case 'ENOENT':
      return 'there is no such file.';
    case 'EACCES':
      return 'may not be opened (permission denied).';
    case 'EROFS':
      return 'this place can only be read.';
    case 'EBUSY':
      return 'is in use by another program.';
    case 'ENOSPC':
      return 'the disk is full.';
    case 'ENOTDIR':
    case 'EISDIR':
      return 'a folder and a file are mixed up in this path.';
    default:
      return error instanceof Error ? error.message : String(error);
  }
}
