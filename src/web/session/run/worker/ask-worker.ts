/** The answer of a worker that has failed. */
interface Failed {
  readonly type: 'failed';
  readonly message: string;
}

/**
 * Asks a worker of its own one thing, and ends it.
 *
 * @param signal ends it before: the promise then never settles
 * @returns the first message that comes back
 * @throws Error (as a rejection) when the worker cannot be loaded, or answers that it failed
 */
export async function askWorker<Answer extends { readonly type: string }>(
  createWorker: () => Pick<Worker, 'terminate'>,
  request: object,
  signal?: AbortSignal,
): Promise<Exclude<Answer, Failed>> {
  const worker = createWorker() as Worker;
  signal?.addEventListener('abort', () => worker.terminate());
  try {
    return await new Promise((resolve, reject) => {
      worker.onmessage = ({ data }: MessageEvent<Answer | Failed>) => {
        if (isFailed(data)) reject(new Error(data.message));
        else resolve(data as Exclude<Answer, Failed>);
      };
      worker.onerror = ({ message }) => reject(new Error(message));
      worker.postMessage(request);
    });
  } finally {
    worker.terminate();
  }
}

const isFailed = (data: { readonly type: string }): data is Failed => data.type === 'failed';
