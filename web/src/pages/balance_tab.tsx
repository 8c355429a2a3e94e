// How evenly a job's work is spread over its sub-domains and workers, and how good the expectations
// were.

import { useMemo, useState } from 'preact/hooks';
import type { ColumnTable } from '../api/columns';
import { live } from '../api/hooks';
import type { Job } from '../api/types';
import type { Pair } from '../logic/balance';
import { busyShares, rankedCurves, scatterOf, spreadOf, thinned } from '../logic/balance';
import { bytes, duration, percent, ratio, short, whole } from '../logic/format';
import { harmlessName } from '../logic/harmless';
import { balanceFigures } from '../logic/plain_words';
import { inOrder } from '../logic/task_kinds';
import { Chart } from '../ui/chart';
import { Choice } from '../ui/fields';
import { Empty, Pair as Line } from '../ui/parts';

interface Measure {
  words: string;
  actual: string;
  expected: string;
  form: (value: unknown) => string;
}

const measures: Measure[] = [
  { words: 'Elements', actual: 'elements', expected: 'expected_elements', form: short },
  { words: 'CPU seconds', actual: 'cpu_seconds', expected: 'expected_seconds', form: duration },
  { words: 'Peak memory', actual: 'peak_rss_bytes', expected: 'expected_bytes', form: bytes },
];

function pairsOf(tasks: ColumnTable, kind: string, measure: Measure): Pair[] {
  const [kinds, states] = [tasks.text('kind'), tasks.text('state')];
  const [actual, expected] = [tasks.number(measure.actual), tasks.number(measure.expected)];
  const pairs: Pair[] = [];
  for (let row = 0; row < tasks.count; ++row) {
    if (kinds[row] !== kind || states[row] !== 'done') continue;
    pairs.push({ actual: actual[row]!, expected: expected[row]! });
  }
  return pairs;
}

function MeasureView({ tasks, kind, measure }: { tasks: ColumnTable; kind: string; measure: Measure }) {
  const { spread, curves, scatter } = useMemo(() => {
    const pairs = pairsOf(tasks, kind, measure);
    return {
      spread: spreadOf(pairs.map((pair) => pair.actual)),
      curves: rankedCurves(pairs),
      scatter: scatterOf(pairs),
    };
  }, [tasks, kind, measure]);
  const { words, form } = measure;
  if (spread.count === 0) {
    return (
      <section class="measure">
        <h3>{words}</h3>
        <Empty>Not told of tasks of this kind.</Empty>
      </section>
    );
  }
  return (
    <section class="measure">
      <h3>{words}</h3>
      <p class="faint">
        max {form(spread.max)}, mean {form(spread.mean)}: max / mean{' '}
        <strong>{ratio(spread.max, spread.mean)}</strong> over {whole(spread.count)}
      </p>
      <div class="charts">
        <Chart
          title={`${words} of the tasks, sorted, with what was expected`}
          xWords="Rank"
          isXWhole
          form={form}
          xForm={whole}
          fromZero
          series={[
            { words: 'Actual', colour: 'chart-1', look: 'line' },
            { words: 'Expected', colour: 'chart-2', look: 'points' },
          ]}
          data={curves}
        />
        {scatter[0].length > 0 ? (
          <Chart
            title={`${words}: actual over expected`}
            xWords="Expected"
            form={form}
            xForm={form}
            fromZero
            series={[
              { words: 'Actual', colour: 'chart-1', look: 'points' },
              { words: 'As expected', colour: 'chart-2', look: 'dashed' },
            ]}
            data={scatter}
          />
        ) : (
          <Empty>No expectation is told.</Empty>
        )}
      </div>
    </section>
  );
}

function Workers({ attempts }: { attempts: ColumnTable }) {
  const workers = useMemo(() => {
    const [started, ended] = [attempts.number('started_ms'), attempts.number('ended_ms')];
    const [worker, host, process] = [attempts.text('worker'), attempts.text('host'), attempts.number('process')];
    const nowMs = live.farm?.time_ms ?? Date.now();
    return busyShares(attempts.count, (i) => ({
      worker: worker[i] || `${host[i]}:${process[i]}`,
      fromMs: started[i]!,
      toMs: ended[i]! > 0 ? ended[i]! : Math.max(nowMs, started[i]!),
    }));
  }, [attempts]);
  const data = useMemo(() => {
    const kept = thinned(workers.map((worker, i) => ({ share: 100 * worker.share, rank: i + 1 })));
    return [kept.map(({ rank }) => rank), kept.map(({ share }) => share)];
  }, [workers]);
  const spread = spreadOf(workers.map((worker) => worker.share));
  const least = workers[workers.length - 1];
  if (workers.length === 0) return null;
  return (
    <section class="measure">
      <h3>Busy share of the workers</h3>
      <p class="faint">
        mean <strong>{percent(spread.mean)}</strong>, most {percent(spread.max)}
        {least && `, least ${percent(least.share)} (${harmlessName(least.name, 40)})`} over {whole(workers.length)}
      </p>
      <Chart
        title="Busy share of each worker, sorted"
        xWords="Worker, by rank"
        isXWhole
        form={(value) => (typeof value === 'number' ? `${Math.round(value)} %` : '–')}
        xForm={whole}
        fromZero
        series={[{ words: 'Busy', colour: 'chart-1', look: 'bars' }]}
        data={data}
      />
    </section>
  );
}

interface TabProps {
  job: Job;
  tasks: ColumnTable;
  attempts: ColumnTable | undefined;
}

export function BalanceTab({ job, tasks, attempts }: TabProps) {
  const kinds = useMemo(() => inOrder(tasks.text('kind')), [tasks]);
  const [chosen, choose] = useState('');
  const kind = chosen || (kinds.includes('mesh') ? 'mesh' : kinds[0] ?? '');
  const told = balanceFigures(job.balance);
  return (
    <>
      <div class="row filters">
        <Choice
          label="Tasks of kind"
          value={kind}
          options={kinds.map((value) => ({ value, words: value }))}
          onChange={choose}
        />
      </div>
      {told.length > 0 && (
        <dl class="pairs">
          {told.map(({ key, words, text }) => (
            <Line key={key} words={words}>
              {text}
            </Line>
          ))}
        </dl>
      )}
      {measures.map((measure) => (
        <MeasureView key={measure.actual} tasks={tasks} kind={kind} measure={measure} />
      ))}
      {attempts && <Workers attempts={attempts} />}
    </>
  );
}
