//! Shapes that nobody sees: before a triangle that overwrites all pixels of a tile, draws that leave nothing but colours
//! are left out there.

use super::edge_functions::{Edge, edges};
use super::job::{DrawJob, PassJob, TileCommand, TileJob};
use crate::primitive::{Shape, ShapeKind};
use crate::sizes::TILE;

/// So many shapes of a tile are looked at, from the last one on.
const LOOKED_AT: usize = 64;

/// The last triangle that overwrites a tile.
#[derive(Clone, Copy, Debug)]
pub struct TileCover {
    /// Its command in the tile.
    command: usize,
    /// Where it is in its chunk's `binned`.
    at: u32,
    /// The colour attachments that it overwrites, bit by attachment.
    targets: u32,
}

/// The colour attachments that a draw writes, bit by attachment.
fn targets(draw: &DrawJob) -> u32 {
    draw.plan.colors.iter().fold(0, |targets, color| targets | 1 << color.target)
}

impl TileCover {
    /// That of a tile, if there is one with anything before it, and no pixel is watched.
    pub fn last(pass: &PassJob, tile: &TileJob) -> Option<Self> {
        if tile.watched.is_some() {
            return None;
        }
        let mut left = LOOKED_AT;
        for (command, of) in tile.commands.iter().enumerate().rev() {
            let TileCommand::Shapes { chunk, first, end } = *of else { continue };
            let chunk = &pass.chunks[chunk as usize];
            let draw = &pass.draws[chunk.draw];
            if !draw.plan.overwrites() || draw.counter.is_some() || draw.budget.is_stopped {
                continue;
            }
            for at in (first..end).rev() {
                left = left.checked_sub(1)?;
                let shape = &chunk.lists.shapes[chunk.lists.binned[at as usize] as usize];
                if covers(shape, &draw.area, pass, tile) {
                    let has_others = command > 0 || at > first;
                    return has_others.then(|| Self { command, at, targets: targets(draw) });
                }
            }
        }
        None
    }

    /// What is left of a command of the tile; `None` where nothing is.
    pub fn visible(
        &self,
        pass: &PassJob,
        number: usize,
        command: TileCommand,
    ) -> Option<TileCommand> {
        let TileCommand::Shapes { chunk, end, .. } = command else { return Some(command) };
        if number == self.command {
            return Some(TileCommand::Shapes { chunk, first: self.at, end });
        }
        let draw = &pass.draws[pass.chunks[chunk as usize].draw];
        let is_hidden = number < self.command
            && draw.counter.is_none()
            && draw.plan.leaves_only_colors()
            && targets(draw) & !self.targets == 0;
        (!is_hidden).then_some(command)
    }
}

/// Whether a shape covers every pixel of a tile that is in the pass.
fn covers(shape: &Shape, area: &[[i32; 2]; 2], pass: &PassJob, tile: &TileJob) -> bool {
    let first = [tile.x, tile.y];
    let last = [(first[0], pass.width), (first[1], pass.height)]
        .map(|(first, size)| (first + TILE as i32).min(size as i32) - 1);
    let is_inside = (0..2).all(|axis| {
        let (low, high) = (shape.bounds[0][axis].into(), shape.bounds[1][axis].into());
        first[axis] >= area[0][axis].max(low) && last[axis] < area[1][axis] && last[axis] <= high
    });
    // The least value of an edge function is at a corner.
    let [across, up] = [0, 1].map(|axis| i64::from(last[axis] - first[axis]));
    let is_inside_edge = |edge: Edge| {
        let (x, y) = (i64::from(edge.x) * across, i64::from(edge.y) * up);
        edge.value + x.min(0) + y.min(0) >= 0
    };
    shape.kind == ShapeKind::Triangle
        && is_inside
        && edges(&shape.corners, first[0], first[1]).into_iter().all(is_inside_edge)
}
