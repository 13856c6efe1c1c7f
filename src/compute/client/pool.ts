/** What computes one job at a time: a worker's end in the page. */
export interface Lane {
  /** Nothing more is heard of it. */
  close(): void;
}

/** Computes many jobs, as many at a time as there are lanes; each lane takes the next job as soon as it is free. */
export class Pool<L extends Lane> {
  readonly size: number;
  private readonly open: () => L;
  private lanes: L[] = [];
  /** Rises with every start and stop: what an earlier batch still says is not heard. */
  private batch = 0;

  /** @param size lanes, at least one */
  constructor(open: () => L, size: number) {
    this.open = open;
    this.size = Math.max(1, size);
  }

  /**
   * Begins with jobs 0 .. count - 1, in that order; a batch under way is stopped.
   * @param work begins a job on a lane and calls `done` once, when it is over
   * @param finished after the last job
   */
  start(count: number, work: (lane: L, job: number, done: () => void) => void, finished: () => void = () => {}): void {
    this.stop();
    const { batch } = this;
    let begun = 0;
    let over = 0;
    const proceed = (lane: L): void => {
      if (begun >= count) {
        lane.close();
        this.lanes = this.lanes.filter((l) => l !== lane);
        return;
      }
      const job = begun++;
      let told = false;
      work(lane, job, () => {
        if (told || batch !== this.batch) return;
        told = true;
        over++;
        // Not from within `work`: a job that is refused at once would nest as deep as there are jobs.
        queueMicrotask(() => batch === this.batch && proceed(lane));
        if (over === count) finished();
      });
    };
    for (let k = 0; k < Math.min(this.size, count); k++) {
      const lane = this.open();
      this.lanes.push(lane);
      proceed(lane);
    }
  }

  /** Ends every lane; jobs not begun never are. */
  stop(): void {
    this.batch++;
    for (const lane of this.lanes) lane.close();
    this.lanes = [];
  }
}
