// How good the elements are: the smallest angle of each sub-domain as it comes, and all angles of the
// mesh once it is done.

import { useMemo } from 'preact/hooks';
import type { ColumnTable } from '../api/columns';
import type { Job } from '../api/types';
import { counted, figure, percent, whole } from '../logic/format';
import type { Shapes } from '../logic/quality';
import { binned, columnsOfBins, inPercent, shapesOf, smallestAngles } from '../logic/quality';
import { isJobLive } from '../logic/states';
import { Chart } from '../ui/chart';
import { Empty } from '../ui/parts';

const degrees = (value: unknown) => `${figure(value)}°`;
const share = (value: unknown) => (typeof value === 'number' ? percent(value / 100) : '–');
const stepOfSmallest = 2; // degrees

interface SmallestProps {
  tasks: ColumnTable;
  kind: 'mesh' | 'cosmetic';
  words: string;
  what: string;
}

function Smallest({ tasks, kind, words, what }: SmallestProps) {
  const angles = useMemo(() => smallestAngles(tasks, kind), [tasks, kind]);
  const data = useMemo(() => columnsOfBins(binned(angles, stepOfSmallest)), [angles]);
  if (angles.length === 0) return null;
  const least = angles.reduce((a, b) => Math.min(a, b));
  return (
    <section class="measure">
      <h3>{words}</h3>
      <p class="faint">
        {what} Of {counted(angles.length, 'sub-domain')} so far; the smallest of all is <strong>{degrees(least)}</strong>.
      </p>
      <Chart
        title={`${words}: how many sub-domains have which`}
        xWords="Degrees"
        form={whole}
        xForm={degrees}
        fromZero
        series={[{ words: 'Sub-domains', colour: 'chart-1', look: 'bars' }]}
        data={data}
      />
    </section>
  );
}

function Part({ words, shapes }: { words: string; shapes: Shapes }) {
  const data = useMemo(() => columnsOfBins(inPercent(shapes.bins)), [shapes]);
  return (
    <div>
      <p>
        <strong>{words}</strong>: {whole(shapes.elements)} tetrahedra, angles from {degrees(shapes.minDegrees)} to{' '}
        {degrees(shapes.maxDegrees)}, mean radius ratio {figure(shapes.meanRadiusRatio)}
      </p>
      <Chart
        title={`Dihedral angles, ${words.toLowerCase()}`}
        xWords="Degrees"
        form={share}
        xForm={degrees}
        fromZero
        series={[{ words: 'Share of the angles', colour: 'chart-1', look: 'bars' }]}
        data={data}
      />
    </div>
  );
}

function Result({ job }: { job: Job }) {
  const parts = useMemo(() => {
    const told: [string, Shapes | undefined][] = [
      ['Near the cuts', shapesOf(job.result?.near_cuts)],
      ['Away from the cuts', shapesOf(job.result?.away_from_cuts)],
    ];
    return told.filter((part): part is [string, Shapes] => part[1] !== undefined);
  }, [job.result]);
  if (parts.length === 0) return null;
  return (
    <section class="measure">
      <h3>Dihedral angles of the mesh</h3>
      <p class="faint">All six of each tetrahedron, in steps of 10°, as shares.</p>
      <div class="charts">
        {parts.map(([words, shapes]) => (
          <Part key={words} words={words} shapes={shapes} />
        ))}
      </div>
    </section>
  );
}

export function QualityTab({ job, tasks }: { job: Job; tasks: ColumnTable }) {
  const isTold = useMemo(
    () => smallestAngles(tasks, 'mesh').length + smallestAngles(tasks, 'cosmetic').length > 0,
    [tasks],
  );
  const isOfResult = shapesOf(job.result?.near_cuts) ?? shapesOf(job.result?.away_from_cuts);
  if (!isTold && !isOfResult) {
    return <Empty>{isJobLive(job.state) ? 'No sub-domain is meshed yet.' : 'Nothing is told of the elements of this job.'}</Empty>;
  }
  return (
    <>
      <Result job={job} />
      <Smallest
        tasks={tasks}
        kind="mesh"
        words="Smallest angle of each sub-domain, as meshed"
        what="Before the elements near the cuts are improved together with those of the neighbours."
      />
      <Smallest
        tasks={tasks}
        kind="cosmetic"
        words="Smallest angle near the cuts, after cosmetics"
        what="Of what the turn of each sub-domain has improved."
      />
    </>
  );
}
