#include "filters/io/image/jpeg_image.h"

#include <csetjmp>
#include <cstdio>
// jpeglib.h needs FILE of <cstdio>.
#include <jerror.h>
#include <jpeglib.h>

#include "filters/core/base/file_limits.h"

namespace boxprobe {

namespace {

// The library reports errors by longjmp, so the calling function must have trivial locals only.
struct JpegFailure {
  jpeg_error_mgr manager;  // first member: the library only has its address
  std::jmp_buf jump;
  char text[JMSG_LENGTH_MAX];
};

void fail(j_common_ptr common) {
  auto* failure = reinterpret_cast<JpegFailure*>(common->err);
  common->err->format_message(common, failure->text);
  std::longjmp(failure->jump, 1);
}

// The library would continue with grey.
void warn(j_common_ptr common, int level) {
  const int code = common->err->msg_code;
  if (level < 0 && (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER || code == JWRN_HUFF_BAD_CODE)) fail(common);
}

void limitScans(j_common_ptr common) {
  if (reinterpret_cast<j_decompress_ptr>(common)->input_scan_number > limits::kJpegScans) {
    ERREXIT(common, JERR_BAD_PROGRESSION);
  }
}

/// Cyan, magenta, yellow, black to RGBA, in place. Ink that lets all light through is 255 if `inverted`, else 0.
void showInks(unsigned char* texels, std::size_t count, bool inverted) {
  for (unsigned char* texel = texels; texel < texels + count; texel += 4) {
    const unsigned black = inverted ? texel[3] : 255u - texel[3];
    for (int c = 0; c < 3; ++c) {
      const unsigned ink = inverted ? texel[c] : 255u - texel[c];
      texel[c] = static_cast<unsigned char>((ink * black + 127u) / 255u);
    }
    texel[3] = 255;
  }
}

bool read(const unsigned char* bytes, std::size_t size, int width, int height, unsigned char* rgba,
          JpegFailure& failure) {
  jpeg_decompress_struct jpeg;
  jpeg_progress_mgr progress = {};
  jpeg.err = jpeg_std_error(&failure.manager);
  failure.manager.error_exit = fail;
  failure.manager.emit_message = warn;
  jpeg_create_decompress(&jpeg);
  if (setjmp(failure.jump) != 0) {
    jpeg_destroy_decompress(&jpeg);
    return false;
  }
  progress.progress_monitor = limitScans;
  jpeg.progress = &progress;
  jpeg_mem_src(&jpeg, bytes, static_cast<unsigned long>(size));
  jpeg_read_header(&jpeg, TRUE);
  const bool inks = jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK;
  jpeg.out_color_space = inks ? JCS_CMYK : JCS_EXT_RGBA;
  jpeg_start_decompress(&jpeg);
  if (jpeg.output_width != static_cast<JDIMENSION>(width) || jpeg.output_height != static_cast<JDIMENSION>(height)) {
    ERREXIT(&jpeg, JERR_BAD_STATE);
  }
  const std::size_t row = std::size_t(4) * static_cast<std::size_t>(width);
  while (jpeg.output_scanline < jpeg.output_height) {
    JSAMPROW to = rgba + row * jpeg.output_scanline;
    jpeg_read_scanlines(&jpeg, &to, 1);
    // Adobe's programs, which mark their files, store what the inks let through in place of their amounts.
    if (inks) showInks(to, row, jpeg.saw_Adobe_marker != 0);
  }
  jpeg_destroy_decompress(&jpeg);  // data after the picture is ignored
  return true;
}

}  // namespace

bool isJpeg(const unsigned char* bytes, std::size_t size) {
  return size >= 2 && bytes[0] == 0xff && bytes[1] == 0xd8;
}

std::string decodeJpeg(const unsigned char* bytes, std::size_t size, int width, int height, unsigned char* rgba) {
  JpegFailure failure;
  failure.text[0] = '\0';
  if (read(bytes, size, width, height, rgba, failure)) return {};
  return failure.text[0] != '\0' ? failure.text : "no picture";
}

}  // namespace boxprobe
